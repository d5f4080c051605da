#include "language/common/expression.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

namespace robcogen::language {
namespace {

using Kind = Expression::Kind;

// How tightly an expression binds; a weaker one inside a stronger one needs parentheses.
enum Strength { sum = 0, product = 1, sign = 2, operand = 3 };

Strength strength(const Expression& e) {
  switch (e.kind) {
    case Kind::add:
    case Kind::subtract:
      return sum;
    case Kind::multiply:
    case Kind::divide:
      return product;
    case Kind::negate:
      return sign;
    case Kind::number:
      return e.number.value() < 0 ? sign : operand;
    default:
      return operand;
  }
}

std::string inside(const Expression& e, Strength least) {
  const std::string text = print(e);
  return strength(e) < least ? "(" + text + ")" : text;
}

// Prints a number without an exponent, which the first RobCoGen did not read, unless it is too large or too small to be
// readable.
std::string decimal(const Number& number) {
  const double value = number.value(), magnitude = std::abs(value);
  if (magnitude < 1e-300 || magnitude >= 1e20) return print_double(value);
  std::array<char, 400> buffer;
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  std::string text(buffer.data(), written.ptr);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

bool same(const ExpressionPtr& a, const ExpressionPtr& b) {
  return a && b ? equal(*a, *b) : a == b;
}

}  // namespace

ExpressionPtr literal(Span span, const Number& number) {
  Expression e;
  e.span = span;
  e.number = number;
  return std::make_shared<const Expression>(std::move(e));
}

std::string print(const Expression& e) {
  switch (e.kind) {
    case Kind::number:
      return decimal(e.number);
    case Kind::pi:
      return e.name;
    case Kind::name: {
      const std::string group = e.is_parameter ? "p:" : e.group.empty() ? "" : e.group + ".";
      return group + (e.escaped ? "^" : "") + e.name + (e.default_value ? "[" + decimal(*e.default_value) + "]" : "");
    }
    case Kind::constant:
      return std::string("<") + (e.escaped ? "^" : "") + e.name + (e.left ? "=" + print(*e.left) : "") + ">";
    case Kind::negate:
      return "-" + inside(*e.left, sign);
    case Kind::add:
      return inside(*e.left, sum) + " + " + inside(*e.right, product);
    case Kind::subtract:
      return inside(*e.left, sum) + " - " + inside(*e.right, product);
    case Kind::multiply: {
      // The first RobCoGen reads the product of a number and a name only without '*'. It does not have parameters with
      // default values.
      const bool is_name = e.right->kind == Kind::pi || (e.right->kind == Kind::name && !e.right->default_value);
      const bool is_plain = e.right->group.empty() && !e.right->is_parameter;
      const bool juxtaposed = e.left->kind == Kind::number && is_name && is_plain;
      return inside(*e.left, product) + (juxtaposed ? " " : " * ") + inside(*e.right, sign);
    }
    case Kind::divide:
      return inside(*e.left, product) + "/" + inside(*e.right, sign);
    case Kind::sine:
      return "sin(" + print(*e.left) + ")";
    case Kind::cosine:
      return "cos(" + print(*e.left) + ")";
    case Kind::tangent:
      return "tan(" + print(*e.left) + ")";
    case Kind::square_root:
      return "sqrt(" + print(*e.left) + ")";
  }
  assert(false && "unknown kind of expression");
  return "";
}

bool equal(const Expression& a, const Expression& b) {
  return a.kind == b.kind && a.number == b.number && a.name == b.name && a.group == b.group &&
         a.is_parameter == b.is_parameter && a.default_value == b.default_value && same(a.left, b.left) &&
         same(a.right, b.right);
}

}  // namespace robcogen::language
