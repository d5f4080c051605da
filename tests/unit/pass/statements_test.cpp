// Passes that remove and move statements: text in, text out.
#include <gtest/gtest.h>

#include "pass/passes.h"
#include "pass/statements.h"
#include "symbolic/programs.h"

namespace robcogen::pass::statements_test {
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

// The earliest reader decides, even if it has been moved itself.
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
}  // namespace robcogen::pass::statements_test
