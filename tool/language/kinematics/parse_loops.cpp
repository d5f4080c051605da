#include "language/kinematics/parse_loops.h"

#include <algorithm>

namespace robcogen::language::kinematics {
namespace {

const WordList kLoopItems = {"frames", "type", "distance", "branch"};
const WordList kActuatorItems = {"from", "to"};
const WordList kTendonItems = {"length", "stiffness", "damping", "rest"};

// Whether the cursor is at an item of an element of these blocks, rather than at an element that has the name of one.
auto at_item(const Cursor& cursor, const WordList& items) {
  return [&] { return cursor.at_any(items) && cursor.at("=", 1); };
}

void take_comments(BlockParser& parser, Body& body) {
  Cursor& cursor = parser.cursor();
  for (std::string& comment : cursor.comments_before(cursor.previous().span.end))
    body.loop_comments.push_back(std::move(comment));
}

void type(BlockParser& parser, LoopJoint& loop) {
  Cursor& cursor = parser.cursor();
  if (!cursor.at_any(kLoopTypes)) {
    const Token found = cursor.peek();
    if (found.kind != Token::Kind::identifier) cursor.unexpected("a type of loop", "after '='");
    cursor
        .error_at(
            found.span, "unknown-loop-type",
            fmt::format("expected {} as the type of a loop, found {}", quoted(kLoopTypes), describe(found)))
        .hint = found.text == "distance" ? "write 'distance = …' instead of the type"
                                         : suggest_keyword(found.text, {kLoopTypes.begin(), kLoopTypes.end()});
    throw SyntaxError{};
  }
  const Token word = cursor.take();
  loop.type = {std::string(word.text), word.span};
}

void branch(BlockParser& parser, LoopJoint& loop) {
  Cursor& cursor = parser.cursor();
  if (!cursor.at_any(kLoopBranches)) {
    const Token found = cursor.peek();
    cursor
        .error_at(
            found.span, "unknown-branch",
            fmt::format("expected {} as the branch of a loop, found {}", quoted(kLoopBranches), describe(found)))
        .hint =
        "'drawn' is the assembly closest to the drawn position of the joints, 'other' the second solution of the "
        "formulas";
    throw SyntaxError{};
  }
  const Token word = cursor.take();
  loop.branch = {std::string(word.text), word.span};
}

void loop(BlockParser& parser, Body& body) {
  Cursor& cursor = parser.cursor();
  LoopJoint loop;
  loop.name = parser.name("the name of a loop");
  const std::string owner = fmt::format("loop '{}'", loop.name.text);
  Words found;
  const bool sound = parser.block(owner, at_item(cursor, kLoopItems), [&] {
    if (!cursor.at_any(kLoopItems)) parser.unknown_item(owner, kLoopItems);
    const Token key = parser.word(found);
    parser.equals(key);
    if (key.text == "frames") {
      loop.frames[0] = parser.name("the name of a frame");
      cursor.expect("~", fmt::format("after '{}'", loop.frames[0].text));
      loop.frames[1] = parser.name("the name of a frame");
    } else if (key.text == "type") {
      type(parser, loop);
    } else if (key.text == "branch") {
      branch(parser, loop);
    } else {
      loop.distance = parser.scalar();
    }
  });
  if (!sound || !parser.check_complete(owner, loop.name.span, found, {"frames"})) return;
  const bool has_type = !loop.type.text.empty();
  if (has_type == (loop.distance != nullptr)) {
    cursor.error_at(loop.name.span, "loop-type", owner + (has_type ? " has a type and a distance" : " has no type"))
        .hint = has_type ? "a loop has a type or keeps a distance: remove one of them"
                         : fmt::format("write 'type = …' with one of {}, or 'distance = …'", quoted(kLoopTypes));
    return;
  }
  body.loop_joints.push_back(std::move(loop));
}

void actuator(BlockParser& parser, Body& body) {
  Actuator actuator;
  actuator.name = parser.name("the name of an actuator");
  const std::string owner = fmt::format("actuator '{}'", actuator.name.text);
  Words found;
  const bool is_sound = parser.block(owner, at_item(parser.cursor(), kActuatorItems), [&] {
    if (!parser.cursor().at_any(kActuatorItems)) parser.unknown_item(owner, kActuatorItems);
    const Token key = parser.word(found);
    parser.equals(key);
    actuator.frames[key.text == "from" ? 0 : 1] = parser.name("the name of a frame");
  });
  if (is_sound && parser.check_complete(owner, actuator.name.span, found, {"from", "to"}))
    body.actuators.push_back(std::move(actuator));
}

void tendon(BlockParser& parser, Body& body) {
  Tendon tendon;
  tendon.name = parser.name("the name of a tendon");
  const std::string owner = fmt::format("tendon '{}'", tendon.name.text);
  Words found;
  const bool is_sound = parser.block(owner, at_item(parser.cursor(), kTendonItems), [&] {
    if (!parser.cursor().at_any(kTendonItems)) parser.unknown_item(owner, kTendonItems);
    const Token key = parser.word(found);
    parser.equals(key);
    (key.text == "length"      ? tendon.length
     : key.text == "stiffness" ? tendon.stiffness
     : key.text == "damping"   ? tendon.damping
                               : tendon.rest) = parser.scalar();
  });
  if (is_sound && parser.check_complete(owner, tendon.name.span, found, {"length"}))
    body.tendons.push_back(std::move(tendon));
}

// Parses a block of elements, each of which has a name and a block.
template <class Element>
void named_blocks(BlockParser& parser, Body& body, Element element) {
  Cursor& cursor = parser.cursor();
  const Token word = cursor.take();
  parser.block(
      fmt::format("'{}'", word.text),
      [&] {
        return cursor.at_name() && cursor.at("{", 1) &&
               !cursor.at_any({"couplings", "loops", "independent", "actuators", "tendons"});
      },
      [&] { element(parser, body); });
  take_comments(parser, body);
}

}  // namespace

bool at_loops(const Cursor& cursor) {
  return cursor.at("loops") && cursor.at("{", 1);
}

bool at_actuators(const Cursor& cursor) {
  return cursor.at("actuators") && cursor.at("{", 1);
}

bool at_tendons(const Cursor& cursor) {
  return cursor.at("tendons") && cursor.at("{", 1);
}

bool at_independent(const Cursor& cursor) {
  return cursor.at("independent") && cursor.at("{", 1);
}

void loops(BlockParser& parser, Body& body) {
  named_blocks(parser, body, loop);
}

void actuators(BlockParser& parser, Body& body) {
  named_blocks(parser, body, actuator);
}

void tendons(BlockParser& parser, Body& body) {
  named_blocks(parser, body, tendon);
}

void independent(BlockParser& parser, Body& body) {
  Cursor& cursor = parser.cursor();
  cursor.take();
  cursor.expect("{", "after 'independent'");
  do body.independents.push_back(parser.name("the name of a joint"));
  while (cursor.accept(","));
  if (!cursor.accept("}")) cursor.unexpected("',' or '}'", "in the list of joints");
  take_comments(parser, body);
}

}  // namespace robcogen::language::kinematics
