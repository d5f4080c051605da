#include "backend/common/spelling.h"

#include <utility>

#include "support/concat.h"

namespace robcogen::backend {
namespace {

using symbolic::Op;

// A text with its parentheses, if it has any.
struct Enclosed {
  std::string_view open, text, close;
};

Enclosed enclosed(const Spelling& v, bool parentheses) {
  if (!parentheses) return {"", v.text, ""};
  return {"(", v.text, ")"};
}

// `a operation b`, preceded by `sign`, which may be empty. Operators associate to the left, so that an operand of equal
// precedence needs parentheses only on the right or behind a sign.
std::string_view operation_text(
    std::string_view sign,
    const Spelling& a,
    std::string_view operation,
    const Spelling& b,
    Precedence precedence,
    Texts& texts) {
  const Enclosed left = enclosed(a, sign.empty() ? a.precedence < precedence : a.precedence <= precedence);
  const Enclosed right = enclosed(b, b.precedence <= precedence);
  return texts.add({sign, left.open, left.text, left.close, operation, right.open, right.text, right.close});
}

Spelling sum(Spelling a, Spelling b, Texts& texts) {
  const bool minus_first = a.negative && !b.negative;                                // -a + b is b - a
  const bool literal_first = a.literal && !b.literal && !a.negative && !b.negative;  // reads better on the right
  if (minus_first || literal_first) std::swap(a, b);
  Spelling result;
  result.precedence = Precedence::sum;
  // Two negative terms leave one sign in front.
  const char* const sign = a.negative ? "-" : "";
  const char* const operation = b.negative ? " - " : " + ";
  result.text = operation_text(sign, a, operation, b, Precedence::sum, texts);
  if (b.negative && !a.negative) result.opposite = operation_text("", b, operation, a, Precedence::sum, texts);
  return result;
}

Spelling product(Op op, Spelling a, Spelling b, Texts& texts) {
  if (op == Op::multiply && b.literal && !a.literal) std::swap(a, b);
  Spelling result;
  result.precedence = Precedence::product;
  result.negative = a.negative != b.negative;
  result.text = operation_text("", a, op == Op::multiply ? " * " : " / ", b, Precedence::product, texts);
  result.literal_first = a.literal_first;
  if (a.literal_first) result.opposite = texts.add({a.opposite, result.text.substr(a.text.size())});
  return result;
}

}  // namespace

Spelling literal(std::string_view text, std::string_view opposite) {
  Spelling result;
  result.text = text;
  result.opposite = opposite;
  result.literal = result.literal_first = true;
  return result;
}

Spelling literal(std::string_view number, Texts& texts) {
  return literal(texts.add({number}), texts.add({"-", number}));
}

Spelling binary(Op op, Spelling a, Spelling b, Texts& texts) {
  if (op == Op::subtract) b.negative = !b.negative;
  return op == Op::add || op == Op::subtract ? sum(a, b, texts) : product(op, a, b, texts);
}

Spelling call(std::string_view function, const Spelling& argument, Texts& texts) {
  Spelling result;
  result.text = texts.add({function, "(", text(argument), ")"});
  return result;
}

Spelling call(std::string_view function, const Spelling& first, const Spelling& second, Texts& texts) {
  Spelling result;
  result.text = texts.add({function, "(", text(first), ", ", text(second), ")"});
  return result;
}

std::string text(const Spelling& value) {
  if (!value.negative) return std::string(value.text);
  if (!value.opposite.empty()) return std::string(value.opposite);
  const auto [open, text, close] = enclosed(value, value.precedence == Precedence::sum);
  return concat({"-", open, text, close});
}

}  // namespace robcogen::backend
