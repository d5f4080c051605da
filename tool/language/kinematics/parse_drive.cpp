#include "language/kinematics/parse_drive.h"

namespace robcogen::language::kinematics {
namespace {

const WordList kLimitItems = {"position", "velocity", "effort"};

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
  return cursor.at_any({"damping", "armature", "limits"});
}

bool drive_item(BlockParser& parser, const std::string& owner, const Token& word, Joint& joint) {
  if (word.text == "limits") return limits(parser, owner, joint.limits);
  parser.equals(word);
  (word.text == "damping" ? joint.drive.damping : joint.drive.armature) = parser.scalar();
  return true;
}

}  // namespace robcogen::language::kinematics
