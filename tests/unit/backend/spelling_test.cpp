#include "backend/cpp/lower.h"

#include <gtest/gtest.h>

namespace robcogen::backend::cpp::spelling_test {
namespace {

using symbolic::Op;

Texts texts;

Spelling binary(Op op, const Spelling& a, const Spelling& b) {
  return backend::binary(op, a, b, texts);
}

Spelling name(std::string_view text, bool negative = false) {
  Spelling s;
  s.text = text;
  s.negative = negative;
  return s;
}

const Spelling a = name("a"), b = name("b"), c = name("c");
const Spelling minus_a = name("a", true), minus_b = name("b", true);

TEST(Spelling, LeftAssociationNeedsNoParentheses) {
  EXPECT_EQ(text(binary(Op::add, binary(Op::add, a, b), c)), "a + b + c");
  EXPECT_EQ(text(binary(Op::subtract, binary(Op::subtract, a, b), c)), "a - b - c");
  EXPECT_EQ(text(binary(Op::multiply, binary(Op::divide, a, b), c)), "a / b * c");
}

TEST(Spelling, RightAssociationKeepsParentheses) {
  EXPECT_EQ(text(binary(Op::add, a, binary(Op::add, b, c))), "a + (b + c)");
  EXPECT_EQ(text(binary(Op::subtract, a, binary(Op::subtract, b, c))), "a - (b - c)");
  EXPECT_EQ(text(binary(Op::multiply, a, binary(Op::multiply, b, c))), "a * (b * c)");
  EXPECT_EQ(text(binary(Op::divide, a, binary(Op::multiply, b, c))), "a / (b * c)");
  EXPECT_EQ(text(binary(Op::multiply, a, binary(Op::divide, b, c))), "a * (b / c)");
}

TEST(Spelling, PrecedenceNeedsParenthesesOnlyAgainstTheGrain) {
  EXPECT_EQ(text(binary(Op::add, a, binary(Op::multiply, b, c))), "a + b * c");
  EXPECT_EQ(text(binary(Op::multiply, binary(Op::add, a, b), c)), "(a + b) * c");
  EXPECT_EQ(text(binary(Op::multiply, a, binary(Op::subtract, b, c))), "a * (b - c)");
}

TEST(Spelling, SignsTurnIntoAdditionAndSubtraction) {
  EXPECT_EQ(text(binary(Op::add, a, minus_b)), "a - b");
  EXPECT_EQ(text(binary(Op::subtract, a, minus_b)), "a + b");
  EXPECT_EQ(text(binary(Op::add, minus_a, b)), "b - a");
  EXPECT_EQ(text(binary(Op::add, minus_a, minus_b)), "-a - b");
  EXPECT_EQ(text(binary(Op::subtract, minus_a, b)), "-a - b");
}

TEST(Spelling, SignsMoveOutOfProducts) {
  EXPECT_EQ(text(binary(Op::multiply, minus_a, b)), "-a * b");
  EXPECT_EQ(text(binary(Op::multiply, minus_a, minus_b)), "a * b");
  EXPECT_EQ(text(binary(Op::divide, a, minus_b)), "-a / b");
  EXPECT_EQ(text(binary(Op::add, c, binary(Op::multiply, a, minus_b))), "c - a * b");
}

TEST(Spelling, TheNegativeOfADifferenceIsTheOtherDifference) {
  Spelling difference = binary(Op::subtract, binary(Op::add, a, b), c);
  difference.negative = true;
  EXPECT_EQ(text(difference), "c - (a + b)");
  EXPECT_EQ(text(binary(Op::multiply, difference, c)), "-(a + b - c) * c");
}

TEST(Spelling, TheNegativeOfASumKeepsItsMinus) {
  Spelling sum = binary(Op::add, a, b);
  sum.negative = true;
  EXPECT_EQ(text(sum), "-(a + b)");
  EXPECT_EQ(text(binary(Op::subtract, sum, c)), "-(a + b) - c");
}

TEST(Spelling, LiteralsReadAsPeopleWriteThem) {
  const Spelling k = literal(0.35, texts);
  Spelling minus_k = k;
  minus_k.negative = true;
  EXPECT_EQ(text(k), "Scalar(0.35)");
  EXPECT_EQ(text(minus_k), "Scalar(-0.35)");
  EXPECT_EQ(text(binary(Op::multiply, a, k)), "Scalar(0.35) * a");
  EXPECT_EQ(text(binary(Op::multiply, a, minus_k)), "Scalar(-0.35) * a");
  EXPECT_EQ(text(binary(Op::add, k, a)), "a + Scalar(0.35)");
  EXPECT_EQ(text(binary(Op::subtract, k, a)), "Scalar(0.35) - a");
  EXPECT_EQ(text(binary(Op::add, minus_k, a)), "a - Scalar(0.35)");
  EXPECT_EQ(text(binary(Op::divide, literal(1, texts), a)), "Scalar(1.0) / a");
}

TEST(Spelling, CallsEncloseWholeExpressions) {
  EXPECT_EQ(text(call("sqrt", binary(Op::add, a, b), texts)), "sqrt(a + b)");
  EXPECT_EQ(text(call("sqrt", minus_a, texts)), "sqrt(-a)");
}

}  // namespace
}  // namespace robcogen::backend::cpp::spelling_test
