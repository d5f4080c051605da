#include "language/common/parse_named_value.h"

#include <utility>

namespace robcogen::language {
namespace {

using Kind = Expression::Kind;

Number signed_number(Cursor& cursor, std::string_view context) {
  const bool negative = cursor.accept("-");
  if (!negative) cursor.accept("+");
  if (cursor.peek().kind != Token::Kind::number) cursor.unexpected("a number", context);
  const Number number = number_of(cursor.take());
  return negative ? -number : number;
}

// Parses the name, and the value after the symbol.
Expression constant(Cursor& cursor, std::size_t begin, std::string_view before_value) {
  const Token name = cursor.expect_name("the name of a constant");
  Expression e;
  e.kind = Kind::constant;
  e.name = name.text;
  e.escaped = name.escaped;
  if (cursor.accept(before_value)) {
    const std::size_t value_begin = cursor.peek().span.begin;
    const Number value = signed_number(cursor, "as the value of a constant");
    e.left = literal({value_begin, cursor.previous().span.end}, value);
  }
  e.span = {begin, cursor.previous().span.end};
  return e;
}

// `<name=3.2>` declares a constant, `<name>` uses it.
ExpressionPtr named_constant(Cursor& cursor) {
  const Token open = cursor.take();
  Expression e = constant(cursor, open.span.begin, "=");
  e.span.end = cursor.expect(">", "after a named constant").span.end;
  return std::make_shared<const Expression>(std::move(e));
}

// `c:name:1.5` declares a constant, `c:name` uses it.
ExpressionPtr coloned_constant(Cursor& cursor) {
  const std::size_t begin = cursor.take().span.begin;
  cursor.take();  // ':'
  return std::make_shared<const Expression>(constant(cursor, begin, ":"));
}

// `p:name`, `p:name[1.5]`
ExpressionPtr coloned_parameter(Cursor& cursor) {
  const std::size_t begin = cursor.take().span.begin;
  cursor.take();  // ':'
  const Token name = cursor.expect_name("the name of a parameter");
  Expression e;
  e.kind = Kind::name;
  e.name = name.text;
  e.escaped = name.escaped;
  e.is_parameter = true;
  e.span = {begin, name.span.end};
  accept_default(cursor, e);
  return std::make_shared<const Expression>(std::move(e));
}

// `group.name`; in the group `consts`, it is a constant.
ExpressionPtr member(Cursor& cursor) {
  const Token group = cursor.take();
  cursor.take();  // '.'
  const Token name = cursor.expect_name("the name of a parameter");
  Expression e;
  e.kind = group.text == "consts" ? Kind::constant : Kind::name;
  e.name = name.text;
  e.escaped = name.escaped;
  if (e.kind == Kind::name) e.group = group.text;
  e.span = {group.span.begin, name.span.end};
  if (e.kind == Kind::name) accept_default(cursor, e);
  return std::make_shared<const Expression>(std::move(e));
}

}  // namespace

ExpressionPtr parse_named_value(Cursor& cursor) {
  if (cursor.at("<")) return named_constant(cursor);
  if (cursor.at("c") && cursor.at(":", 1)) return coloned_constant(cursor);
  if (cursor.at("p") && cursor.at(":", 1)) return coloned_parameter(cursor);
  if (cursor.at_name() && cursor.at(".", 1)) return member(cursor);
  return nullptr;
}

bool accept_default(Cursor& cursor, Expression& parameter) {
  if (!cursor.accept("[")) return false;
  parameter.default_value = signed_number(cursor, "as the default of a parameter");
  parameter.span.end = cursor.expect("]", "after the default of a parameter").span.end;
  return true;
}

}  // namespace robcogen::language
