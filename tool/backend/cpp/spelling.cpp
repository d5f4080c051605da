#include "backend/cpp/spelling.h"

#include <string_view>
#include <utility>

#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

using symbolic::Op;

constexpr std::string_view kLiteral = "Scalar(";

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
  result.text =
      left_of(Precedence::product, a) + (op == Op::multiply ? " * " : " / ") + right_of(Precedence::product, b);
  return result;
}

}  // namespace

Spelling literal(double value) {
  Spelling result;
  result.text = std::string(kLiteral) + print_double(value) + ")";
  result.literal = true;
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
  if (value.precedence != Precedence::sum && value.text.starts_with(kLiteral))
    return std::string(kLiteral) + "-" + value.text.substr(kLiteral.size());
  return "-" + enclosed(value.text, value.precedence == Precedence::sum);
}

}  // namespace robcogen::backend::cpp
