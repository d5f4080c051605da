#include "language/kinematics/parse_drive.h"

namespace robcogen::language::kinematics {
namespace {

const WordList kFrictionItems = {"force", "velocity"};
const WordList kSpringItems = {"stiffness", "rest"};
const WordList kElasticItems = {"stiffness", "damping"};
const WordList kRotorItems = {"inertia", "ratio", "axis", "carrier"};
const WordList kLimitItems = {"position", "velocity", "effort"};

// Parses a block of two values, of which only the first is mandatory. A word behind the block is one of its items,
// whose brace is misplaced, if `at_item`.
template <class AtItem>
bool pair(
    BlockParser& parser,
    const std::string& owner,
    const Token& word,
    WordList items,
    AtItem at_item,
    ExpressionPtr& first,
    ExpressionPtr& second) {
  Words found;
  const bool sound = parser.block(owner, at_item, [&] {
    if (!parser.cursor().at_any(items)) parser.unknown_item(owner, items);
    const Token key = parser.word(found);
    parser.equals(key);
    (key.text == *items.begin() ? first : second) = parser.scalar();
  });
  return sound && parser.check_complete(owner, word.span, found, {*items.begin()});
}

bool pair(
    BlockParser& parser,
    const std::string& owner,
    const Token& word,
    WordList items,
    ExpressionPtr& first,
    ExpressionPtr& second) {
  return pair(
      parser, owner, word, items, [&] { return parser.cursor().at_any(items); }, first, second);
}

bool rotor(BlockParser& parser, const std::string& joint, const Token& word, std::optional<Rotor>& read) {
  const std::string owner = "the rotor of " + joint;
  Rotor rotor;
  rotor.span = word.span;
  Words found;
  const bool sound = parser.block(owner, kRotorItems, [&] {
    if (!parser.cursor().at_any(kRotorItems)) parser.unknown_item(owner, kRotorItems);
    const Token key = parser.word(found);
    parser.equals(key);
    if (key.text == "axis") {
      rotor.axis = parser.vector(key);
    } else if (key.text == "carrier") {
      rotor.carrier = parser.name("the name of a link");
    } else {
      (key.text == "inertia" ? rotor.inertia : rotor.ratio) = parser.scalar();
    }
  });
  read = rotor;
  return sound && parser.check_complete(owner, word.span, found, {"inertia", "ratio"});
}

bool elasticity(BlockParser& parser, const std::string& joint, const Token& word, std::optional<Elasticity>& read) {
  Elasticity& spring = read.emplace();
  spring.span = word.span;
  // A `damping` behind the block is that of the joint.
  const auto at_item = [&] { return parser.cursor().at(*kElasticItems.begin()); };
  return pair(parser, "the elasticity of " + joint, word, kElasticItems, at_item, spring.stiffness, spring.damping);
}

bool limits(BlockParser& parser, const std::string& joint, Limits& limits) {
  const std::string owner = "the limits of " + joint;
  Words found;
  return parser.block(owner, kLimitItems, [&] {
    if (!parser.cursor().at_any(kLimitItems)) parser.unknown_item(owner, kLimitItems);
    const Token key = parser.word(found);
    parser.equals(key);
    if (key.text == "position") {
      const std::vector<ExpressionPtr> bounds = parser.components(key, 2);
      limits.position = {bounds[0], bounds[1]};
    } else {
      (key.text == "velocity" ? limits.velocity : limits.effort) = parser.scalar();
    }
  });
}

}  // namespace

bool at_drive_item(const Cursor& cursor) {
  return cursor.at_any({"damping", "friction", "armature", "spring", "elastic", "rotor", "limits", "assembled"});
}

bool drive_item(BlockParser& parser, const std::string& owner, const Token& word, DriveAndLimits& items) {
  Drive& drive = items.drive;
  if (word.text == "limits") return limits(parser, owner, items.limits);
  if (word.text == "rotor") return rotor(parser, owner, word, items.rotor);
  if (word.text == "elastic") return elasticity(parser, owner, word, items.elasticity);
  if (word.text == "spring")
    return pair(parser, "the spring of " + owner, word, kSpringItems, drive.stiffness, drive.rest);
  if (word.text == "friction" && parser.cursor().at("{"))
    return pair(parser, "the friction of " + owner, word, kFrictionItems, drive.friction, drive.friction_velocity);
  parser.equals(word);
  (word.text == "damping"     ? drive.damping
   : word.text == "friction"  ? drive.friction
   : word.text == "assembled" ? items.assembled
                              : drive.armature) = parser.scalar();
  return true;
}

}  // namespace robcogen::language::kinematics
