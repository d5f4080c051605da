#include <algorithm>
#include <climits>
#include <utility>

#include "language/common/content.h"
#include "language/kinematics/block_parser.h"
#include "language/kinematics/keywords.h"
#include "language/kinematics/parse_couplings.h"
#include "language/kinematics/parse_drive.h"
#include "language/kinematics/parse_loops.h"
#include "language/kinematics/parse_part.h"

namespace robcogen::language::kinematics {
namespace {

const WordList kLinkItems = {"id", "inertia_params", "inertia_properties", "children", "frames"};
const WordList kLinkNeeds = {"id", "children"};
const WordList kLinkNeedsInPart = {"children"};
const WordList kBaseItems = {"inertia_params", "inertia_properties", "children", "frames"};
const WordList kInertiaItems = {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame"};
const WordList kInertiaNeeds = {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz"};
const WordList kJointItems = {"id", "ref_frame", "damping", "friction", "armature", "spring", "rotor", "limits"};
const WordList kHelicalItems = {"id",       "ref_frame", "pitch", "damping", "friction",
                                "armature", "spring",    "rotor", "limits"};
const WordList kJointNeeds = {"ref_frame"}, kHelicalNeeds = {"ref_frame", "pitch"};
const WordList kCylindricalItems = {"id", "ref_frame", "slide", "turn"};
const WordList kUniversalItems = {"id", "ref_frame", "turn_x", "turn_z"};
const WordList kPlanarItems = {"id", "ref_frame", "slide_x", "slide_y", "turn"};
const WordList kCoordinateItems = {"damping", "friction", "armature", "spring", "rotor", "limits"};
constexpr std::string_view kCouplings = "couplings";

// Elements stand in the block of the robot, items in the block of an element, both in any order.
class Parser : private BlockParser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : BlockParser(Cursor(tokenize_document(source, diagnostics), keywords(), diagnostics)),
        source_(std::move(source)),
        errors_before_(diagnostics.error_count()),
        diagnostics_(diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      imports_and_parts();
      if (!is_library()) {
        header();
        elements();
        end();
        check_bases();
      }
    } catch (const SyntaxError&) {
    } catch (const OtherLanguage&) {
      // reported; the rest of the file is not read
    }
    std::stable_partition(
        document_.links.begin(), document_.links.end(), [](const Link& link) { return link.is_base; });
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  std::size_t errors_before_;
  const Diagnostics& diagnostics_;
  Document document_;
  Body* body_ = &document_;     // of the robot, or of the present part
  const Part* part_ = nullptr;  // the present one
  std::vector<Name> bases_;     // including those with errors
  bool may_have_skipped_base_ = false;

  // -------------------------------------------------------------------------------------------------------------------
  // The robot: its header, its elements, its end.

  void imports_and_parts() {
    while (cursor_.at("import") || at_part(cursor_)) {
      cursor_.begin_statement();
      try {
        if (cursor_.at("import"))
          document_.imports.push_back(import_of(*this));
        else
          part();
      } catch (const SyntaxError&) {
        cursor_.skip_until([&] { return at_robot() || at_part(cursor_) || at_element(); });
        if (!at_robot() && !at_part(cursor_)) throw;
      }
    }
  }

  bool at_robot() const { return cursor_.at("Robot") && cursor_.at("{", 2); }

  // Imports and parts alone, for other documents.
  bool is_library() {
    if (!cursor_.at_end() || (document_.imports.empty() && document_.parts.empty())) return false;
    document_.trailing_comments = cursor_.comments_before(source_->text().size() + 1);
    return true;
  }

  void part() {
    Part part = part_head(*this);
    const std::string owner = fmt::format("part '{}'", part.name.text);
    const Token open = cursor_.expect("{", "after " + owner);
    body_ = &part;
    part_ = &part;
    elements(&part.roots);
    body_ = &document_;
    part_ = nullptr;
    if (at_robot()) {
      cursor_.error("missing-brace", fmt::format("expected '}}' at the end of {}, found 'Robot'", owner))
          .notes.push_back({cursor_.place(open.span), "opened here"});
      cursor_.assume_closing_brace();
    } else {
      cursor_.expect("}", "at the end of " + owner);
    }
    part.trailing_comments = cursor_.comments_before(cursor_.previous().span.end);
    if (part.roots.empty())
      cursor_.error_at(part.name.span, "no-root", fmt::format("{} has no root", owner)).hint =
          "write 'root LINK via JOINT' for its first link and the joint that carries it";
    document_.parts.push_back(std::move(part));
  }

  void header() {
    document_.comments = cursor_.comments_before(cursor_.peek().span.begin);
    try {
      cursor_.expect("Robot", "at the beginning of a robot document");
      document_.robot = name("the name of the robot");
      cursor_.expect("{", "after the name of the robot");
    } catch (const SyntaxError&) {
      may_have_skipped_base_ = true;
      cursor_.skip_until([&] { return at_element(); });
      if (cursor_.at_end()) throw;
    }
  }

  void elements(std::vector<Child>* roots = nullptr) {
    while (!cursor_.at("}") && !cursor_.at_end() && !(roots && at_robot())) {
      cursor_.begin_statement();
      try {
        if (roots && at_root(cursor_)) {
          roots->push_back(root(*this));
        } else if (cursor_.at_any({"RobotBase", "link"})) {
          link();
        } else if (cursor_.at_any({"r_joint", "p_joint"}) || at_new_element()) {
          joint();
        } else if (at_couplings()) {
          couplings(*this, *body_);
        } else if (at_loops(cursor_)) {
          loops(*this, *body_);
        } else if (at_independent(cursor_)) {
          independent(*this, *body_);
        } else {
          unknown_element();
        }
      } catch (const SyntaxError&) {
        cursor_.skip_until([&] { return at_element(); });
        if (cursor_.at_end()) throw;
      }
    }
  }

  // Not a keyword: elements may have this name.
  bool at_couplings() const { return cursor_.at(kCouplings) && cursor_.at("{", 1); }

  void unknown_element() {
    may_have_skipped_base_ = true;
    const Token& token = cursor_.peek();
    if (!cursor_.is_faulty_here()) {
      Diagnostic& d = cursor_.error(
          "unknown-element", fmt::format("expected {} or '}}', found {}", quoted(kElements), describe(token)));
      std::vector<std::string> words(kElements.begin(), kElements.end());
      words.insert(words.end(), kNewElements.begin(), kNewElements.end());
      words.insert(words.end(), {std::string(kCouplings), "loops", "independent"});
      if (token.kind == Token::Kind::identifier) d.hint = suggest_keyword(token.text, words);
      if (at_instance(cursor_)) d.hint = "a part stands in 'children' of the link that carries it";
    }
    cursor_.skip_until([&] { return cursor_.at("{") || cursor_.at("}") || at_element(); });
    if (!cursor_.accept("{")) return;
    const std::size_t inside = cursor_.open_blocks();
    cursor_.skip_until([&] { return at_element() || (cursor_.at("}") && cursor_.open_blocks() == inside); });
    cursor_.accept("}");
  }

  // When elements follow the brace that ends the robot, there is one brace too many before it: they are read too. After
  // other errors this is not reported: they may be about a brace.
  void end() {
    if (cursor_.at_end() && cursor_.open_blocks() == 0) return;  // there was an error in the header
    const Token brace = cursor_.expect("}", "at the end of the robot");
    document_.trailing_comments = cursor_.comments_before(source_->text().size() + 1);
    if (cursor_.at_end()) return;
    const bool is_part = at_part(cursor_) || cursor_.at("import");
    const bool may_follow = at_element() && diagnostics_.error_count() > errors_before_;
    if (!may_follow && !cursor_.is_faulty_here()) report_text_after(brace, is_part);
    while (at_element()) {
      elements();
      cursor_.take();
    }
  }

  void report_text_after(const Token& brace, bool is_part) {
    Diagnostic& d =
        cursor_.error("text-after-end", fmt::format("{} stands after the end of the robot", describe(cursor_.peek())));
    d.notes.push_back({cursor_.place(brace.span), "the robot ends here"});
    if (is_part) d.hint = "imports and parts stand before the robot";
  }

  void check_bases() {
    if (bases_.empty() && !may_have_skipped_base_)
      cursor_.error_at(
          document_.robot.span, "no-base", fmt::format("robot '{}' has no RobotBase", document_.robot.text));
    for (std::size_t i = 1; i < bases_.size(); ++i)
      cursor_.error_at(bases_[i].span, "two-bases", fmt::format("'{}' is a second base", bases_[i].text))
          .notes.push_back({cursor_.place(bases_[0].span), "the first base is here"});
  }

  // -------------------------------------------------------------------------------------------------------------------
  // Links.

  void link() {
    Link link;
    const Token keyword = cursor_.take();
    link.is_base = keyword.text == "RobotBase";
    if (link.is_base && part_ == nullptr) bases_.push_back({std::string(cursor_.peek().text), cursor_.peek().span});
    if (link.is_base && part_ != nullptr)
      cursor_.error_at(keyword.span, "base-in-part", fmt::format("part '{}' cannot have a base", part_->name.text))
          .hint =
          "a part is attached to a link: write 'root LINK via JOINT' for its first link and the joint that carries it";
    link.name = name(link.is_base ? "the name of the base" : "the name of a link");
    const std::string owner = fmt::format("{} '{}'", link.is_base ? "base" : "link", link.name.text);
    link.floating = link.is_base && cursor_.accept("floating");
    if (link.is_base && !link.floating && !cursor_.at("{")) cursor_.unexpected("'floating' or '{'", "after " + owner);
    Words found;
    const bool sound = block(owner, kLinkItems, [&] {
      if (cursor_.at("id")) {
        const Token id = word(found);
        if (link.is_base) cursor_.error_at(id.span, "base-with-id", "a base cannot have an 'id'");
        link.id_span = id.span;
        link.id = integer(id);
      } else if (cursor_.at_any({"inertia_params", "inertia_properties"})) {
        link.inertia = inertia(word(found), owner);
      } else if (cursor_.at("children")) {
        word(found);
        children(link);
      } else if (cursor_.at("frames")) {
        word(found);
        frames(link);
      } else {
        if (cursor_.at("ref_frame")) old_dialect("a 'ref_frame' of a link");
        unknown_item(owner, link.is_base ? kBaseItems : kLinkItems);
      }
    });
    if (sound && link.is_base) check_complete(owner, link.name.span, found, {"children"});
    if (sound && !link.is_base)
      check_complete(owner, link.name.span, found, part_ != nullptr ? kLinkNeedsInPart : kLinkNeeds);
    link.span = {keyword.span.begin, cursor_.previous().span.end};
    link.comments = cursor_.comments_before(link.span.end);
    body_->links.push_back(std::move(link));
  }

  int integer(const Token& key) {
    equals(key);
    const bool is_negative = cursor_.at("-") && cursor_.peek(1).kind == Token::Kind::number;
    const Token token = cursor_.peek(is_negative ? 1 : 0);
    const bool is_integer = !is_negative && token.kind == Token::Kind::number &&
                            token.text.find_first_not_of("0123456789") == std::string::npos &&
                            number_of(token).value() <= INT_MAX;
    if (!is_integer) {
      const std::string expected = fmt::format("an integer from 0 to {}", INT_MAX);
      if (cursor_.after_line_end() || cursor_.is_faulty_here()) cursor_.unexpected(expected, "after '='");
      const Span span = {cursor_.peek().span.begin, token.span.end};
      const std::string found = is_negative ? fmt::format("number '-{}'", token.text) : describe(token);
      cursor_.error_at(span, "bad-id", fmt::format("expected {} as id, found {}", expected, found));
      throw SyntaxError{};
    }
    cursor_.take();
    return static_cast<int>(number_of(token).value());
  }

  void children(Link& link) {
    block(
        "'children'", [&] { return (cursor_.at_name() && cursor_.at("via", 1)) || at_instance(cursor_); },
        [&] {
          if (at_instance(cursor_)) {
            link.instances.push_back(instance(*this));
            return;
          }
          Child child;
          child.link = name("the name of a child link");
          cursor_.expect("via", fmt::format("after '{}'", child.link.text));
          child.joint = name("the name of a joint");
          link.children.push_back(std::move(child));
        },
        kLinkItems);
  }

  // One block, or several in a row; blocks may be empty.
  void frames(Link& link) {
    do {
      block(
          "'frames'", [&] { return cursor_.at_name() && cursor_.at("{", 1); },
          [&] {
            const Name name = this->name("the name of a frame");
            const auto placement = this->placement(fmt::format("frame '{}'", name.text), name.span);
            if (placement) link.frames.push_back({name, *placement});
          },
          kLinkItems);
    } while (cursor_.at("{"));
  }

  // nullopt when something in it was reported.
  std::optional<Inertia> inertia(const Token& keyword, const std::string& link) {
    Inertia inertia;
    const std::string owner = fmt::format("the inertia of {}", link);
    const std::array moments = {std::pair("Ix", &inertia.ix),   std::pair("Iy", &inertia.iy),
                                std::pair("Iz", &inertia.iz),   std::pair("Ixy", &inertia.ixy),
                                std::pair("Ixz", &inertia.ixz), std::pair("Iyz", &inertia.iyz)};
    Words found;
    const bool sound = block(
        owner, kInertiaItems,
        [&] {
          const Token key = cursor_.peek();
          if (cursor_.at_any({"moments", "products"})) old_dialect(fmt::format("'{}'", key.text));
          if (!cursor_.at_any(kInertiaItems)) unknown_item(owner, kInertiaItems);
          word(found);
          equals(key);
          if (key.text == "ref_frame") {
            inertia.reference = name("the name of a frame");
          } else if (key.text == "CoM") {
            inertia.com = vector(key);
          } else if (key.text == "mass") {
            inertia.mass = scalar();
          } else {
            for (const auto& [moment, value] : moments)
              if (key.text == moment) *value = scalar();
          }
        },
        kLinkItems);
    inertia.span = {keyword.span.begin, cursor_.previous().span.end};
    if (!sound || !check_complete(owner, keyword.span, found, kInertiaNeeds)) return std::nullopt;
    return inertia;
  }

  // -------------------------------------------------------------------------------------------------------------------
  // Joints, placements, numbers.

  void joint() {
    Joint joint;
    const Token keyword = cursor_.take();
    joint.type = type_of(keyword.text);
    const WordList& items = items_of(joint.type);
    joint.name = name("the name of a joint");
    const std::string owner = fmt::format("joint '{}'", joint.name.text);
    std::optional<Placement> placement;
    Words found;
    bool sound_items = true;
    bool sound = block(owner, items, [&] {
      if (!cursor_.at_any(items)) {
        if (cursor_.at("translation")) old_dialect("a 'translation' outside 'ref_frame'");
        if (at_instance(cursor_)) attached_to_joint(owner);
        unknown_item(owner, items);
      }
      const Token key = word(found);
      if (key.text == "id") {
        joint.id = integer(key);
      } else if (key.text == "ref_frame") {
        placement = this->placement(fmt::format("the 'ref_frame' of {}", owner), key.span);
      } else if (key.text == "pitch") {
        equals(key);
        joint.pitch = scalar();
      } else if (is_coordinate(joint.type, key.text)) {
        sound_items = coordinate(owner, key, joint) && sound_items;
      } else {
        sound_items = drive_item(*this, owner, key, {joint.drive, joint.rotor, joint.limits}) && sound_items;
      }
    });
    const WordList& needed = joint.type == Joint::Type::helical ? kHelicalNeeds : kJointNeeds;
    sound = sound && sound_items && check_complete(owner, joint.name.span, found, needed);
    joint.span = {keyword.span.begin, cursor_.previous().span.end};
    joint.comments = cursor_.comments_before(joint.span.end);
    if (!sound || !placement) return;
    joint.placement = *placement;
    body_->joints.push_back(std::move(joint));
  }

  static Joint::Type type_of(std::string_view word) {
    using enum Joint::Type;
    for (const Joint::Type type : {prismatic, helical, cylindrical, universal, planar, spherical})
      if (word == word_of(type)) return type;
    return revolute;
  }

  static const WordList& items_of(Joint::Type type) {
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

  static bool is_coordinate(Joint::Type type, std::string_view word) {
    const auto words = coordinate_words(type);
    return std::find(words.begin(), words.end(), word) != words.end();
  }

  // Drive and limits of one of several coordinates.
  bool coordinate(const std::string& joint_owner, const Token& key, Joint& joint) {
    Coordinate read;
    read.word = {std::string(key.text), key.span};
    const std::string owner = fmt::format("coordinate '{}' of {}", key.text, joint_owner);
    Words found;
    bool sound_drive = true;
    const bool sound = block(owner, kCoordinateItems, [&] {
      if (!at_drive_item(cursor_)) unknown_item(owner, kCoordinateItems);
      sound_drive = drive_item(*this, owner, word(found), {read.drive, read.rotor, read.limits}) && sound_drive;
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
        .hint = "a part stands in 'children' of a link";
    throw SyntaxError{};
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::kinematics
