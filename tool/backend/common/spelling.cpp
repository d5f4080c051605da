#include "backend/common/spelling.h"

#include <utility>

namespace robcogen::backend {
namespace {

using symbolic::Op;

std::string enclosed(const std::string& text, bool parentheses) {
  return parentheses ? "(" + text + ")" : text;
}

// Equal precedence needs parentheses on the right only: operators associate to the left.
std::string left_of(Precedence operation, const Spelling& v) {
  return enclosed(v.text, v.precedence < operation);
}
std::string right_of(Precedence operation, const Spelling& v) {
  return enclosed(v.text, v.precedence <= operation);
}

Spelling sum(Spelling a, Spelling b) {
  const bool minus_first = a.negative && !b.negative;                                // -a + b is b - a
  const bool literal_first = a.literal && !b.literal && !a.negative && !b.negative;  // reads better on the right
  if (minus_first || literal_first) std::swap(a, b);
  Spelling result;
  result.precedence = Precedence::sum;
  // Two negative terms leave one sign in front.
  const std::string left = a.negative ? "-" + right_of(Precedence::sum, a) : left_of(Precedence::sum, a);
  result.text = left + (b.negative ? " - " : " + ") + right_of(Precedence::sum, b);
  if (b.negative && !a.negative) result.opposite = left_of(Precedence::sum, b) + " - " + right_of(Precedence::sum, a);
  return result;
}

Spelling product(Op op, Spelling a, Spelling b) {
  if (op == Op::multiply && b.literal && !a.literal) std::swap(a, b);
  Spelling result;
  result.precedence = Precedence::product;
  result.negative = a.negative != b.negative;
  const std::string rest = (op == Op::multiply ? " * " : " / ") + right_of(Precedence::product, b);
  result.text = left_of(Precedence::product, a) + rest;
  result.literal_first = a.literal_first;
  if (a.literal_first) result.opposite = a.opposite + rest;
  return result;
}

}  // namespace

Spelling literal(const std::string& text, const std::string& opposite) {
  Spelling result;
  result.text = text;
  result.opposite = opposite;
  result.literal = result.literal_first = true;
  return result;
}

Spelling binary(Op op, Spelling a, Spelling b) {
  if (op == Op::subtract) b.negative = !b.negative;
  return op == Op::add || op == Op::subtract ? sum(std::move(a), std::move(b))
                                             : product(op, std::move(a), std::move(b));
}

Spelling call(const std::string& function, const Spelling& argument) {
  Spelling result;
  result.text = function + "(" + text(argument) + ")";
  return result;
}

std::string text(const Spelling& value) {
  if (!value.negative) return value.text;
  if (!value.opposite.empty()) return value.opposite;
  return "-" + enclosed(value.text, value.precedence == Precedence::sum);
}

}  // namespace robcogen::backend
