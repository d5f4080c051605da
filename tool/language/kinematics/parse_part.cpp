#include "language/kinematics/parse_part.h"

#include "language/common/parse_expression.h"

namespace robcogen::language::kinematics {
namespace {

// Parses `( item, item )` if there is such a list.
template <class Item>
void list(Cursor& cursor, const std::string& owner, Item item) {
  if (!cursor.accept("(")) return;
  if (cursor.accept(")")) return;
  do item();
  while (cursor.accept(","));
  if (!cursor.accept(")")) cursor.unexpected("',' or ')'", "in the list of " + owner);
}

bool at_mirror(const Cursor& cursor) {
  return cursor.at("mirrored") && !cursor.at("via", 1) && !at_instance(cursor);
}

Mirror mirror(BlockParser& parser) {
  Cursor& cursor = parser.cursor();
  const Token word = cursor.take();
  if (!cursor.at_any({"x", "y", "z"})) cursor.unexpected("'x', 'y' or 'z'", "after 'mirrored'");
  Mirror result;
  result.axis = cursor.take().text[0] - 'x';
  if (cursor.at("same") && cursor.at("sense", 1)) {
    cursor.take();
    cursor.take();
    result.same_sense = true;
    if (cursor.accept("{")) {
      do result.joints.push_back(parser.name("the name of a joint"));
      while (!cursor.at("}"));
      cursor.take();
    }
  }
  result.span = {word.span.begin, cursor.previous().span.end};
  return result;
}

}  // namespace

Import import_of(BlockParser& parser) {
  Cursor& cursor = parser.cursor();
  const Token word = cursor.take();
  Import result;
  result.comments = cursor.comments_before(word.span.begin);
  if (cursor.peek().kind != Token::Kind::string)
    cursor.unexpected("the name of a file in double quotes", "after 'import'");
  const Token file = cursor.take();
  result.file = file.text;
  result.span = file.span;
  if (cursor.accept("as")) result.name = parser.name("the name of a part");
  return result;
}

bool at_part(const Cursor& cursor) {
  return cursor.at("Part") && cursor.peek(1).kind == Token::Kind::identifier;
}

Part part_head(BlockParser& parser) {
  Cursor& cursor = parser.cursor();
  const Token word = cursor.take();
  Part part;
  part.comments = cursor.comments_before(word.span.begin);
  part.name = parser.name("the name of a part");
  list(cursor, fmt::format("parameters of part '{}'", part.name.text), [&] {
    PartParameter parameter = {parser.name("the name of a parameter"), nullptr};
    if (cursor.accept("[")) {
      parameter.default_value = parse_expression(cursor);
      cursor.expect("]", fmt::format("after the default of '{}'", parameter.name.text));
    }
    part.parameters.push_back(std::move(parameter));
  });
  return part;
}

bool at_root(const Cursor& cursor) {
  return cursor.at("root") && cursor.peek(1).kind == Token::Kind::identifier;
}

Child root(BlockParser& parser) {
  parser.cursor().take();
  Child child;
  child.link = parser.name("the name of the first link");
  parser.cursor().expect("via", fmt::format("after '{}'", child.link.text));
  child.joint = parser.name("the name of a joint");
  return child;
}

bool at_instance(const Cursor& cursor) {
  return cursor.at_name() && cursor.at_name(1) && (cursor.at("(", 2) || (cursor.at("at", 2) && cursor.at("{", 3)));
}

Instance instance(BlockParser& parser) {
  Cursor& cursor = parser.cursor();
  Instance instance;
  instance.part = parser.name("the name of a part");
  instance.name = parser.name("the prefix of its names");
  const std::string owner = fmt::format("'{}'", instance.name.text);
  list(cursor, "arguments of " + owner, [&] {
    Argument argument;
    argument.name = parser.name("the name of a parameter");
    cursor.expect("=", fmt::format("after '{}'", argument.name.text));
    argument.value = parse_expression(cursor);
    instance.arguments.push_back(std::move(argument));
  });
  if (cursor.at("at") && cursor.at("{", 1)) {
    cursor.take();
    instance.placement = parser.placement("the placement of " + owner, instance.name.span);
  }
  while (at_mirror(cursor)) {
    const Mirror read = mirror(parser);
    if (instance.mirror) {
      cursor.error_at(read.span, "mirrored-twice", fmt::format("{} is mirrored twice", owner)).hint =
          "two reflections make a rotation: write it in 'at { … }'";
    } else {
      instance.mirror = read;
    }
  }
  if (cursor.at("keep") && cursor.at("base", 1)) {
    const Token word = cursor.take();
    instance.keep = {word.span.begin, cursor.take().span.end};
  }
  return instance;
}

}  // namespace robcogen::language::kinematics
