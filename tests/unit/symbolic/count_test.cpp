// Operation counts of programs small enough to count by hand.
#include "symbolic/count.h"

#include <gtest/gtest.h>

#include "programs.h"

namespace robcogen::symbolic {
namespace {

OperationCount counted(const std::string& statements, int outputs = 1) {
  return count(test::small_program(statements, outputs));
}

TEST(Count, NothingCostsNothing) {
  const OperationCount c = counted("return out -a[0]\n");
  EXPECT_EQ(c.mul + c.add + c.div + c.sqrt + c.sincos + c.instructions + c.critical_path, 0);
}

TEST(Count, EachOperationInItsColumn) {
  const OperationCount c = counted(
      "let a1 = a[0] + a[1]\n"
      "let a2 = a1 - a[2]\n"
      "let m1 = a2 * a[3]\n"
      "let d1 = m1 / a[1]\n"
      "let r1 = sqrt d1\n"
      "let s1 = sin r1\n"
      "return out s1 r1\n",
      2);
  EXPECT_EQ(c.add, 2);
  EXPECT_EQ(c.mul, 1);
  EXPECT_EQ(c.div, 1);
  EXPECT_EQ(c.sqrt, 1);
  EXPECT_EQ(c.sincos, 1);
  EXPECT_EQ(c.instructions, 3);  // divisions, roots and sines are counted separately
  EXPECT_EQ(c.critical_path, 4 + 4 + 4 + 14 + 14);
}

TEST(Count, SineAndCosineOfOneAngleAreOne) {
  EXPECT_EQ(counted("let s = sin a[0]\nlet c = cos a[0]\nreturn out s c\n", 2).sincos, 1);
  EXPECT_EQ(counted("let s = sin a[0]\nlet c = cos -a[0]\nreturn out s c\n", 2).sincos, 1);
  EXPECT_EQ(counted("let s = sin a[0]\nlet c = cos a[1]\nreturn out s c\n", 2).sincos, 2);
  // Statement 0 is different from input 0.
  EXPECT_EQ(counted("let t = a[0] * a[1]\nlet s = sin t\nlet c = cos a[0]\nreturn out s c\n", 2).sincos, 2);
}

TEST(Count, ASumSwallowsOneProduct) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nreturn out s\n").instructions, 1);
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = a[2] - m\nreturn out s\n").instructions, 1);
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet n = a[2] * a[3]\nlet s = m + n\nreturn out s\n").instructions, 2);
}

TEST(Count, AProductThatSomethingElseReadsStays) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nreturn out s m\n", 2).instructions, 2);
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nlet n = m * a[2]\nreturn out s n\n", 2).instructions, 3);
}

TEST(Count, AProductInTwoSumsIsSwallowedByBoth) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + a[2]\nlet t = m + a[3]\nreturn out s t\n", 2).instructions, 2);
}

// fma(a, b, m) would still need m.
TEST(Count, ASumOfAProductWithItselfSwallowsNothing) {
  EXPECT_EQ(counted("let m = a[0] * a[1]\nlet s = m + m\nreturn out s\n").instructions, 2);
}

// m, which has one use, fuses with the sum that it shares with n; n, which has two uses, is then needed separately.
TEST(Count, ProductsWithFewestUsesAreSwallowedFirst) {
  EXPECT_EQ(
      counted(
          "let n = a[0] * a[1]\n"
          "let m = a[2] * a[3]\n"
          "let s = n + m\n"
          "let t = n + a[2]\n"
          "return out s t\n",
          2)
          .instructions,
      3);
}

// A chain of n fused operations: one product that is not fused, then n - 1 sums, each fused with a product.
TEST(Count, ADotProductIsAChain) {
  const OperationCount c = counted(
      "let m0 = a[0] * a[0]\n"
      "let m1 = a[1] * a[1]\n"
      "let s1 = m0 + m1\n"
      "let m2 = a[2] * a[2]\n"
      "let s2 = s1 + m2\n"
      "return out s2\n");
  EXPECT_EQ(c.mul, 3);
  EXPECT_EQ(c.add, 2);
  EXPECT_EQ(c.instructions, 3);
  EXPECT_EQ(c.critical_path, 4 + 4 + 4);
}

TEST(Count, TheCriticalPathFusesAtTheLaterFactor) {
  // x is ready at 4, and fma(x, a, b) at 8.
  EXPECT_EQ(counted("let x = a[0] + a[1]\nlet m = x * a[2]\nlet s = m + a[3]\nreturn out s\n").critical_path, 8);
  // The addend is late; in fused form, the sum waits only for the addend.
  EXPECT_EQ(
      counted("let x = a[0] / a[1]\n"
              "let m = a[2] * a[3]\n"
              "let s = m - x\n"
              "return out s\n")
          .critical_path,
      14 + 4);
}

TEST(Count, TheCriticalPathIsOfTheLatestOutput) {
  EXPECT_EQ(
      counted("let x = a[0] + a[1]\nlet y = a[0] / a[1]\nlet dead = sqrt y\nreturn out x y\n", 2).critical_path, 14);
}

TEST(Count, SinesAreGiven) {
  EXPECT_EQ(counted("let x = a[0] + a[1]\nlet s = sin x\nlet m = s * a[2]\nreturn out m\n").critical_path, 4);
}

// Parameters change rarely, so values that depend only on them take no time.
TEST(PredictedTime, IsThatBetweenTwoChangesOfTheParameters) {
  const auto program = [](const std::string& role) {
    return test::program(
        "program test\n"
        "input k " +
        role +
        " 0 1\n"
        "input x value 0 1\n"
        "output out value 2 1\n"
        "section hip link hip\n"
        "in 0\n"
        "let d = k[0] / k[1]\n"
        "let e = sqrt d\n"
        "let y = e * x[0]\n"
        "let z = y + x[1]\n"
        "return out z e\n");
  };
  EXPECT_EQ(predicted_time(program("value")), 14 + 14 + 4);
  EXPECT_EQ(predicted_time(program("parameters")), 4);
}

// Programs over two lanes: parameters, and variables.
Program of_lanes(const std::string& role, const std::string& statements, const std::string& returns) {
  return test::program(
      "program test\n"
      "input k " +
      role +
      " 0 1\n"
      "input x value 0 1\n"
      "output out value 2 1\n"
      "section hip link hip\n"
      "in 0\n" +
      statements + "return out " + returns + "\n");
}

// An operation on all lanes counts once; bringing numbers together or apart is a move.
TEST(Count, LanesCountOnce) {
  const OperationCount c = count(of_lanes(
      "value", "tmp a = gather k[0] k[1]\ntmp b = gather x[0] x[1]\ntmp m = a * b\ntmp s = m + a\n", "s@0 s@1"));
  EXPECT_EQ(c.mul, 1);
  EXPECT_EQ(c.add, 1);
  EXPECT_EQ(c.instructions, 1);
  EXPECT_EQ(c.moves, 1 + 1 + 2);  // gathers, and outputs that are lanes
  EXPECT_EQ(c.critical_path, 4);
}

// All lanes together count as one sine, from which a single lane can be read; sines of single lanes count one each.
TEST(Count, SinesOfLanesAreOneAndThoseOfSingleLanesOneEach) {
  const std::string x = "tmp x = gather k[0] k[1]\n";
  EXPECT_EQ(count(of_lanes("value", x + "tmp s = sin x\ntmp c = cos x@0\n", "s@0 c")).sincos, 1);
  EXPECT_EQ(count(of_lanes("value", x + "tmp s = sin x@0\ntmp c = cos x@0\n", "s c")).sincos, 1);
  EXPECT_EQ(count(of_lanes("value", x + "tmp s = sin x@0\ntmp c = cos x@1\n", "s c")).sincos, 2);
}

TEST(Count, ASumOfLanesWaitsForHalves) {
  const OperationCount c =
      count(of_lanes("value", "tmp a = gather k[0] k[1]\ntmp m = a * x[0]\ntmp s = sum_lanes m\n", "s s"));
  EXPECT_EQ(c.instructions, 1);
  EXPECT_EQ(c.moves, 1 + 2);
  EXPECT_EQ(c.critical_path, 4 + 3 + 4);
}

// Vectors of numbers are prepared in advance; a gather of computed values has to be waited for.
TEST(Count, AGatherOfNumbersIsFree) {
  const OperationCount numbers =
      count(of_lanes("value", "tmp a = gather 0.5 -0.25\ntmp m = a * x[0]\ntmp s = sum_lanes m\n", "s s"));
  EXPECT_EQ(numbers.moves, 2);
  const OperationCount computed = count(
      of_lanes("value", "tmp y = x[0] + x[1]\ntmp a = gather y x[1]\ntmp m = a * x[0]\ntmp s = sum_lanes m\n", "s s"));
  EXPECT_EQ(computed.critical_path, 4 + 3 + 4 + 3 + 4);
}

// A gather of parameters depends only on them, and so does everything computed from it.
TEST(Work, AGatherOfParametersIsGiven) {
  const auto program = [](const std::string& role) {
    return of_lanes(
        role, "tmp f = gather k[0] k[1]\ntmp g = gather x[0] x[1]\ntmp r = f * f\ntmp m = r * g\ntmp s = m + x[1]\n",
        "s@0 s@1");
  };
  EXPECT_EQ(work(program("value")), 2 * 3 - 1);
  EXPECT_EQ(work(program("parameters")), 2 * 2 - 1);
}

// A gather with a lane that is not a parameter is not counted as given.
TEST(Work, AGatherOfParametersAndOthersIsNotGiven) {
  const Program program = of_lanes("parameters", "tmp f = gather k[0] x[0]\ntmp r = f * f\n", "r@0 r@1");
  EXPECT_EQ(work(program), 2);
  EXPECT_EQ(work(of_lanes("parameters", "tmp f = gather k[0] k[1]\ntmp r = f * f\ntmp m = r@0 * x[0]\n", "m r@1")), 2);
}

}  // namespace
}  // namespace robcogen::symbolic
