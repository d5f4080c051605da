#include "backend/common/spelling.h"

#include <utility>

namespace robcogen::backend {
namespace {

using symbolic::Op;

std::string enclosed(const std::string& text, bool parentheses) {
  return parentheses ? "(" + text + ")" : text;
}

void append(std::string& text, const Spelling& v, bool parentheses) {
  if (parentheses) text += '(';
  text += v.text;
  if (parentheses) text += ')';
}

// Equal precedence needs parentheses on the right only: operators associate to the left.
std::string joined(const Spelling& a, const char* operation, const Spelling& b, Precedence precedence) {
  constexpr std::size_t kAround = 8;  // an operator between blanks, parentheses around each
  std::string text;
  text.reserve(a.text.size() + b.text.size() + kAround);
  append(text, a, a.precedence < precedence);
  text += operation;
  append(text, b, b.precedence <= precedence);
  return text;
}

Spelling sum(Spelling a, Spelling b) {
  const bool minus_first = a.negative && !b.negative;                                // -a + b is b - a
  const bool literal_first = a.literal && !b.literal && !a.negative && !b.negative;  // reads better on the right
  if (minus_first || literal_first) std::swap(a, b);
  Spelling result;
  result.precedence = Precedence::sum;
  const char* const operation = b.negative ? " - " : " + ";
  if (a.negative) {
    // Two negative terms leave one sign in front.
    a.text = "-" + enclosed(a.text, a.precedence == Precedence::sum);
    a.precedence = Precedence::product;
  }
  result.text = joined(a, operation, b, Precedence::sum);
  if (b.negative && !a.negative) result.opposite = joined(b, operation, a, Precedence::sum);
  return result;
}

Spelling product(Op op, Spelling a, Spelling b) {
  if (op == Op::multiply && b.literal && !a.literal) std::swap(a, b);
  Spelling result;
  result.precedence = Precedence::product;
  result.negative = a.negative != b.negative;
  result.text = joined(a, op == Op::multiply ? " * " : " / ", b, Precedence::product);
  result.literal_first = a.literal_first;
  if (a.literal_first) result.opposite = a.opposite + result.text.substr(a.text.size());
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
