#include "language/desired/parse_frame.h"

#include <fmt/format.h>

#include <utility>

namespace robcogen::language::desired {
namespace {

// 'left' and 'right' are common names of limbs: as the name of an instance, they are not keywords.
bool at_side(const Cursor& cursor) {
  return cursor.at_any({"left", "right"});
}

}  // namespace

bool at_section_word(const Cursor& cursor) {
  return cursor.at_any(kSections);
}

bool at_section(const Cursor& cursor) {
  return at_section_word(cursor) && cursor.at("{", 1);
}

bool at_instance(const Cursor& cursor) {
  return (cursor.at_name() || at_side(cursor)) && cursor.at(".", 1);
}

Name read_name(Cursor& cursor, std::string_view what) {
  const Token token = cursor.expect_name(what);
  return {std::string(token.text), token.span};
}

Name read_instance(Cursor& cursor) {
  if (!at_side(cursor)) return read_name(cursor, "the name of an instance of a part");
  const Token side = cursor.take();
  return {std::string(side.text), side.span};
}

Name read_frame(Cursor& cursor, int loop, std::string_view what) {
  Name result = at_instance(cursor) ? read_instance(cursor) : read_name(cursor, what);
  result.loop = loop;
  if (!cursor.accept(".")) return result;
  result.instance = std::exchange(result.text, {});
  result.instance_span = result.span;
  const Name own = read_name(cursor, fmt::format("the name of a frame of '{}'", result.instance));
  result.text = own.text;
  result.span.end = own.span.end;
  return result;
}

}  // namespace robcogen::language::desired
