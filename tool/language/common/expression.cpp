#include "language/common/expression.h"

namespace robcogen::language {
namespace {

using Kind = Expression::Kind;

// How tightly an expression binds: what needs parentheses inside what.
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

bool same(const ExpressionPtr& a, const ExpressionPtr& b) {
  return a && b ? equal(*a, *b) : a == b;
}

}  // namespace

std::string print(const Expression& e) {
  switch (e.kind) {
    case Kind::number:
      return print_double(e.number.value());
    case Kind::pi:
      return e.name;
    case Kind::name: {
      const std::string group = e.group.empty() ? "" : e.group + ".";
      return group + (e.escaped ? "^" : "") + e.name +
             (e.default_value ? "[" + print_double(e.default_value->value()) + "]" : "");
    }
    case Kind::constant:
      return "<" + e.name + (e.left ? "=" + print_double(e.left->number.value()) : "") + ">";
    case Kind::negate:
      return "-" + inside(*e.left, sign);
    case Kind::add:
      return inside(*e.left, sum) + " + " + inside(*e.right, product);
    case Kind::subtract:
      return inside(*e.left, sum) + " - " + inside(*e.right, product);
    case Kind::multiply: {
      // The original knows the product of a number and a name by juxtaposition only.
      const bool plain = e.left->kind == Kind::number && (e.right->kind == Kind::pi || e.right->kind == Kind::name) &&
                         e.right->group.empty();
      return inside(*e.left, product) + (plain ? " " : " * ") + inside(*e.right, sign);
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
  return "";
}

bool equal(const Expression& a, const Expression& b) {
  return a.kind == b.kind && a.number == b.number && a.name == b.name && a.group == b.group &&
         a.default_value == b.default_value && same(a.left, b.left) && same(a.right, b.right);
}

}  // namespace robcogen::language
