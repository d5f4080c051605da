#include "language/kinematics/parse_joint.h"

#include <algorithm>

#include "language/kinematics/parse_drive.h"
#include "language/kinematics/parse_part.h"

namespace robcogen::language::kinematics {
namespace {

const WordList kJointItems = {"id",     "ref_frame", "damping", "friction", "armature",
                              "spring", "elastic",   "rotor",   "limits",   "assembled"};
const WordList kHelicalItems = {"id",     "ref_frame", "pitch", "damping", "friction", "armature",
                                "spring", "elastic",   "rotor", "limits",  "assembled"};
const WordList kJointNeeds = {"ref_frame"}, kHelicalNeeds = {"ref_frame", "pitch"};
const WordList kCylindricalItems = {"id", "ref_frame", "slide", "turn"};
const WordList kUniversalItems = {"id", "ref_frame", "turn_x", "turn_z"};
const WordList kPlanarItems = {"id", "ref_frame", "slide_x", "slide_y", "turn"};
const WordList kCoordinateItems = {"damping", "friction", "armature", "spring",
                                   "elastic", "rotor",    "limits",   "assembled"};

Joint::Type type_of(std::string_view word) {
  using enum Joint::Type;
  for (const Joint::Type type : {prismatic, helical, cylindrical, universal, planar, spherical})
    if (word == word_of(type)) return type;
  return revolute;
}

const WordList& items_of(Joint::Type type) {
  switch (type) {
    case Joint::Type::revolute:
    case Joint::Type::prismatic:
    case Joint::Type::spherical:
      break;
    case Joint::Type::helical:
      return kHelicalItems;
    case Joint::Type::cylindrical:
      return kCylindricalItems;
    case Joint::Type::universal:
      return kUniversalItems;
    case Joint::Type::planar:
      return kPlanarItems;
  }
  return kJointItems;
}

bool is_coordinate(Joint::Type type, std::string_view word) {
  const auto words = coordinate_words(type);
  return std::find(words.begin(), words.end(), word) != words.end();
}

class JointParser {
 public:
  JointParser(BlockParser& parser, Body& body) : parser_(parser), cursor_(parser.cursor()), body_(body) {}

  void run() {
    Joint joint;
    const Token keyword = cursor_.take();
    joint.type = type_of(keyword.text);
    const WordList& items = items_of(joint.type);
    joint.name = parser_.name("the name of a joint");
    const std::string owner = fmt::format("joint '{}'", joint.name.text);
    std::optional<Placement> placement;
    Words found;
    bool sound_items = true;
    bool sound = parser_.block(owner, items, [&] {
      if (!cursor_.at_any(items)) {
        if (cursor_.at("translation")) parser_.old_dialect("a 'translation' outside 'ref_frame'");
        if (at_instance(cursor_)) attached_to_joint(owner);
        parser_.unknown_item(owner, items);
      }
      const Token key = parser_.word(found);
      if (key.text == "id") {
        joint.id = parser_.integer(key);
      } else if (key.text == "ref_frame") {
        placement = parser_.placement(fmt::format("the 'ref_frame' of {}", owner), key.span);
      } else if (key.text == "pitch") {
        parser_.equals(key);
        joint.pitch = parser_.scalar();
      } else if (is_coordinate(joint.type, key.text)) {
        sound_items = coordinate(owner, key, joint) && sound_items;
      } else {
        sound_items = drive_item(parser_, owner, key, joint) && sound_items;
      }
    });
    const WordList& needed = joint.type == Joint::Type::helical ? kHelicalNeeds : kJointNeeds;
    sound = sound && sound_items && parser_.check_complete(owner, joint.name.span, found, needed);
    joint.span = {keyword.span.begin, cursor_.previous().span.end};
    joint.comments = cursor_.comments_before(joint.span.end);
    if (!sound || !placement) return;
    joint.placement = *placement;
    body_.joints.push_back(std::move(joint));
  }

 private:
  BlockParser& parser_;
  Cursor& cursor_;
  Body& body_;

  // Parses the drive and the limits of one coordinate.
  bool coordinate(const std::string& joint_owner, const Token& key, Joint& joint) {
    Coordinate read;
    read.word = {std::string(key.text), key.span};
    const std::string owner = fmt::format("coordinate '{}' of {}", key.text, joint_owner);
    Words found;
    bool sound_drive = true;
    const bool sound = parser_.block(owner, kCoordinateItems, [&] {
      if (!at_drive_item(cursor_)) parser_.unknown_item(owner, kCoordinateItems);
      sound_drive = drive_item(parser_, owner, parser_.word(found), read) && sound_drive;
    });
    const auto words = coordinate_words(joint.type);
    const auto place = [&](const Coordinate& c) { return std::find(words.begin(), words.end(), c.word.text); };
    const auto before = std::find_if(joint.coordinates.begin(), joint.coordinates.end(), [&](const Coordinate& other) {
      return place(read) < place(other);
    });
    joint.coordinates.insert(before, std::move(read));
    return sound && sound_drive;
  }

  [[noreturn]] void attached_to_joint(const std::string& owner) {
    cursor_.error("attached-to-joint", fmt::format("part '{}' cannot be attached to {}", cursor_.peek().text, owner))
        .hint = "list a part under 'children' of a link";
    throw SyntaxError{};
  }
};

}  // namespace

void joint(BlockParser& parser, Body& body) {
  JointParser(parser, body).run();
}

}  // namespace robcogen::language::kinematics
