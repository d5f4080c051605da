// Passes that drop, merge and move statements: text in, text out.
#include <gtest/gtest.h>

#include "pass/passes.h"
#include "symbolic/programs.h"

namespace robcogen::pass {
namespace {

using symbolic::Program;
using test::head;
using test::small_program;

using Run = Program (*)(Program);

std::string after(Run run, const std::string& statements, int outputs = 1) {
  const std::string text = print(run(small_program(statements, outputs)));
  const std::string start = head(outputs);
  EXPECT_TRUE(text.starts_with(start)) << text;
  return text.substr(start.size());
}

TEST(EliminateDeadCode, DropsWhatNoOutputNeeds) {
  EXPECT_EQ(
      after(
          eliminate_dead_code,
          "in 0\n"
          "tmp dead = a[0] + a[1]\n"
          "tmp live = a[0] * a[1]\n"
          "let dead_too = dead - live\n"
          "in 1\n"
          "tmp last = live + a[2]\n"
          "return out last\n"),
      "in 0\n"
      "tmp live = a[0] * a[1]\n"
      "in 1\n"
      "tmp last = live + a[2]\n"
      "return out last\n");
}

TEST(EliminateDeadCode, MayLeaveNothing) {
  EXPECT_EQ(after(eliminate_dead_code, "tmp dead = a[0] + a[1]\nreturn out a[0]\n"), "return out a[0]\n");
}

TEST(EliminateCommonSubexpressions, ComputesEqualStatementsOnce) {
  EXPECT_EQ(
      after(
          eliminate_common_subexpressions,
          "in 0\n"
          "let first = a[0] + a[1]\n"
          "in 1\n"
          "let again = a[0] + a[1]\n"
          "tmp product = again * first\n"
          "tmp sine = sin first\n"
          "tmp sine_again = sin again\n"
          "return out product -again -sine sine_again\n",
          4),
      "in 0\n"
      "let first = a[0] + a[1]\n"
      "in 1\n"
      "tmp product = first * first\n"
      "tmp sine = sin first\n"
      "return out product -first -sine sine\n");
}

// Statements with opposite operands differ, although their texts look the same.
TEST(EliminateCommonSubexpressions, TheSignOfAnOperandMatters) {
  const std::string different =
      "in 0\n"
      "tmp sum = a[0] + a[1]\n"
      "tmp first_negated = -a[0] + a[1]\n"
      "tmp second_negated = a[0] + -a[1]\n"
      "tmp product = sum * a[2]\n"
      "tmp negated_product = -sum * a[2]\n"
      "tmp root = sqrt sum\n"
      "tmp root_of_negated = sqrt -sum\n"
      "tmp cosine = cos sum\n"
      "tmp sine = sin sum\n"
      "tmp sine_of_negated = sin -sum\n"
      "return out first_negated second_negated product negated_product root root_of_negated cosine sine "
      "sine_of_negated\n";
  EXPECT_EQ(after(eliminate_common_subexpressions, different, 9), different);
}

TEST(EliminateCommonSubexpressions, OperandsOfOneSignAreEqual) {
  EXPECT_EQ(
      after(
          eliminate_common_subexpressions,
          "in 0\n"
          "tmp sum = -a[0] + a[1]\n"
          "tmp again = a[1] + -a[0]\n"
          "tmp root = sqrt -sum\n"
          "tmp root_again = sqrt -again\n"
          "return out root root_again\n",
          2),
      "in 0\n"
      "tmp sum = -a[0] + a[1]\n"
      "tmp root = sqrt -sum\n"
      "return out root root\n");
}

// a - b is not b - a, nor a / b the other quotient, whichever comes first.
TEST(EliminateCommonSubexpressions, DifferencesAndQuotientsDoNotCommute) {
  const std::string different =
      "in 0\n"
      "tmp difference = a[0] - a[1]\n"
      "tmp opposite = a[1] - a[0]\n"
      "tmp quotient = a[2] / a[3]\n"
      "tmp reciprocal = a[3] / a[2]\n"
      "tmp of_statements = difference - quotient\n"
      "tmp other_order = quotient - difference\n"
      "tmp of_constants = 2.0 - a[0]\n"
      "tmp other_constants = a[0] - 2.0\n"
      "return out opposite reciprocal of_statements other_order of_constants other_constants\n";
  EXPECT_EQ(after(eliminate_common_subexpressions, different, 6), different);
}

TEST(EliminateCommonSubexpressions, SumsAndProductsCommute) {
  EXPECT_EQ(
      after(
          eliminate_common_subexpressions,
          "in 0\n"
          "tmp s = a[0] + -a[1]\n"
          "tmp t = -a[1] + a[0]\n"
          "tmp m = a[0] * 0.5\n"
          "tmp n = 0.5 * a[0]\n"
          "return out s t m n\n",
          4),
      "in 0\n"
      "tmp s = a[0] + -a[1]\n"
      "tmp m = a[0] * 0.5\n"
      "return out s s m m\n");
}

TEST(EliminateCommonSubexpressions, WhatDiffersStays) {
  const std::string statements =
      "in 0\n"
      "tmp d = a[0] - a[1]\n"
      "tmp e = a[1] - a[0]\n"
      "tmp q = a[0] / a[1]\n"
      "tmp r = a[1] / a[0]\n"
      "tmp s = a[0] + a[1]\n"
      "tmp t = a[0] + -a[1]\n"
      "tmp u = a[0] * a[1]\n"
      "tmp v = sqrt a[0]\n"
      "tmp w = sqrt -a[0]\n"
      "tmp x = sin a[0]\n"
      "tmp y = cos a[0]\n"
      "tmp z = a[0] + 1.0\n"
      "return out d e q r s t u v w x y z\n";
  EXPECT_EQ(after(eliminate_common_subexpressions, statements, 12), statements);
}

TEST(Sink, MovesAStatementToTheSectionThatReadsIt) {
  EXPECT_EQ(
      after(
          sink,
          "in 0\n"
          "tmp far = a[0] + a[1]\n"
          "tmp near = a[0] - a[1]\n"
          "tmp here = near * a[2]\n"
          "in 1\n"
          "tmp there = far * here\n"
          "return out there here\n",
          2),
      "in 0\n"
      "tmp near = a[0] - a[1]\n"
      "tmp here = near * a[2]\n"
      "in 1\n"
      "tmp far = a[0] + a[1]\n"
      "tmp there = far * here\n"
      "return out there here\n");
}

TEST(Sink, AChainMovesAsAWhole) {
  EXPECT_EQ(
      after(
          sink,
          "in 0\n"
          "tmp x = a[0] + a[1]\n"
          "tmp y = x * a[2]\n"
          "let stay = a[0] * a[3]\n"
          "in 1\n"
          "tmp z = y - stay\n"
          "return out z\n"),
      "in 0\n"
      "let stay = a[0] * a[3]\n"
      "in 1\n"
      "tmp x = a[0] + a[1]\n"
      "tmp y = x * a[2]\n"
      "tmp z = y - stay\n"
      "return out z\n");
}

TEST(Sink, NamedStatementsOutputsAndDeadOnesStay) {
  const std::string statements =
      "in 0\n"
      "let named = a[0] + a[1]\n"
      "tmp output = a[0] - a[1]\n"
      "tmp dead = a[0] * a[1]\n"
      "in 1\n"
      "tmp last = named * output\n"
      "return out last output\n";
  EXPECT_EQ(after(sink, statements, 2), statements);
}

// The earliest reader decides, also where it has moved itself.
TEST(Sink, StopsAtTheEarliestReader) {
  EXPECT_EQ(
      after(
          sink,
          "in 0\n"
          "tmp x = a[0] + a[1]\n"
          "in 1\n"
          "let y = x * a[2]\n"
          "in 0\n"
          "tmp z = y * x\n"
          "return out z\n"),
      "in 1\n"
      "tmp x = a[0] + a[1]\n"
      "let y = x * a[2]\n"
      "in 0\n"
      "tmp z = y * x\n"
      "return out z\n");
}

TEST(Sink, TheOrderWithinASectionStays) {
  EXPECT_EQ(
      after(
          sink,
          "in 0\n"
          "tmp x = a[0] + a[1]\n"
          "tmp y = a[0] - a[1]\n"
          "in 1\n"
          "tmp u = y * y\n"
          "tmp v = x * u\n"
          "return out v\n"),
      "in 1\n"
      "tmp x = a[0] + a[1]\n"
      "tmp y = a[0] - a[1]\n"
      "tmp u = y * y\n"
      "tmp v = x * u\n"
      "return out v\n");
}

}  // namespace
}  // namespace robcogen::pass
