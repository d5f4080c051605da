#include "symbolic/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "programs.h"
#include "symbolic/double_double.h"

namespace robcogen::symbolic::accuracy_test {
namespace {

using test::program;

// Computes x + y, with a number added first and subtracted at the end.
std::string detour(const std::string& number) {
  return "program detour\ninput x value a b\noutput y value 1 1\nsection s s\nin 0\ntmp t0 = x[0] + " + number +
         "\ntmp t1 = t0 + x[1]\ntmp t2 = t1 - " + number + "\nreturn y t2\n";
}

const std::string kSum =
    "program sum\ninput x value a b\noutput y value 1 1\nsection s s\nin 0\ntmp t0 = x[0] + x[1]\nreturn y t0\n";

double sum_of(const DoubleDouble& x) {
  return x.high + x.low;
}

TEST(DoubleDoubles, KeepThirtyDigits) {
  const DoubleDouble third = DoubleDouble{1, 0} / DoubleDouble{3, 0};
  const DoubleDouble one = third + third + third;
  EXPECT_LT(std::abs((one.high - 1.0) + one.low), 1e-31);
  const DoubleDouble root = sqrt(DoubleDouble{2, 0});
  EXPECT_LT(std::abs(sum_of(root * root - DoubleDouble{2, 0})), 1e-31);
  const DoubleDouble tiny{1.0, 1e-25};
  EXPECT_EQ(sum_of(tiny - DoubleDouble{1.0, 0.0}), 1e-25);
}

TEST(DoubleDoubles, SinesAgreeWithTheLibraryAndWithEachOther) {
  for (int k = -400; k <= 400; ++k) {
    const double angle = 0.37 * k;
    const SineCosine both = sine_cosine({angle, 0.0});
    EXPECT_LT(std::abs(both.sine.high - std::sin(angle)), 3e-16) << angle;
    EXPECT_LT(std::abs(both.cosine.high - std::cos(angle)), 3e-16) << angle;
    const DoubleDouble one = both.sine * both.sine + both.cosine * both.cosine;
    EXPECT_LT(std::abs((one.high - 1.0) + one.low), 1e-30) << angle;
  }
}

// sin(a + b) by the addition theorem.
TEST(DoubleDoubles, SinesOfSums) {
  for (int k = 1; k <= 50; ++k) {
    const DoubleDouble a{0.11 * k, 0.0}, b{1.7 - 0.05 * k, 0.0};
    const SineCosine of_a = sine_cosine(a), of_b = sine_cosine(b), of_sum = sine_cosine(a + b);
    const DoubleDouble expected = of_a.sine * of_b.cosine + of_a.cosine * of_b.sine;
    EXPECT_LT(std::abs(sum_of(of_sum.sine - expected)), 1e-30) << k;
  }
}

TEST(Accuracy, OfASumIsARounding) {
  const AccurateResults results(program(kSum));
  EXPECT_LE(results.error_of_plain().in_double, 1.0);
  EXPECT_LE(results.error_of_plain().in_float, 1.0);
}

TEST(Accuracy, DigitsLostOnADetourAreCounted) {
  const AccurateResults results(program(kSum));
  const RoundingError far = results.error_of(program(detour("1048576.0")));
  EXPECT_GT(far.in_float, 1e4);
  EXPECT_FALSE(results.are_kept_by(program(detour("1048576.0"))));
  EXPECT_FALSE(results.are_kept_by(program(detour("1e12"))));
  EXPECT_TRUE(results.are_kept_by(program(detour("2.0"))));
}

// y and z are both x + y, each with a number added and subtracted.
std::string two_detours(const std::string& of_y, const std::string& of_z) {
  return "program detours\ninput x value a b\noutput y value 1 1\noutput z value 1 1\nsection s s\nin 0\ntmp t0 = x[0] "
         "+ " +
         of_y + "\ntmp t1 = t0 + x[1]\ntmp t2 = t1 - " + of_y + "\ntmp t3 = x[0] + " + of_z +
         "\ntmp t4 = t3 + x[1]\ntmp t5 = t4 - " + of_z + "\nreturn y t2\nreturn z t5\n";
}

TEST(Accuracy, LossesOfOneArrayDoNotExcuseThoseOfAnother) {
  const AccurateResults results(program(two_detours("1048576.0", "2.0")));
  EXPECT_TRUE(results.are_kept_by(program(two_detours("1048577.0", "2.0"))));
  EXPECT_FALSE(results.are_kept_by(program(two_detours("1048576.0", "4096.0"))));
}

// y = b, with a number added and subtracted that is large in a few states.
const std::string kRare =
    "program rare\ninput x value a b\noutput y value 1 1\nsection s s\nin 0\ntmp t0 = x[0] * x[0]\ntmp t1 = t0 * t0\n"
    "tmp t2 = t1 * t1\ntmp t3 = 1024.0 * t2\ntmp t4 = x[1] + t3\ntmp t5 = t4 - t3\nreturn y t5\n";

// y = 0.3 b, with a number added and subtracted that is large in fewer states.
const std::string kRarer =
    "program rarer\ninput x value a b\noutput y value 1 1\nsection s s\nin 0\ntmp t0 = x[0] * x[0]\ntmp t1 = t0 * t0\n"
    "tmp t2 = t1 * t1\ntmp t3 = t2 * t2\ntmp t4 = 0.03 * t3\ntmp t5 = 0.3 * x[1]\ntmp t6 = t5 + t4\ntmp t7 = t6 - t4\n"
    "return y t7\n";

// In float, the plain program loses many digits in a few states; the other one loses fewer digits, but in all states.
TEST(Accuracy, FewStatesDoNotExcuseLossesInAll) {
  const AccurateResults results(program(kRare));
  const Program everywhere = program(
      "program everywhere\ninput x value a b\noutput y value 1 1\nsection s s\nin 0\ntmp t0 = x[1] + 16384.0\n"
      "tmp t1 = t0 - 16384.0\nreturn y t1\n");
  EXPECT_LT(results.error_of(everywhere).in_float, results.error_of_plain().in_float);
  EXPECT_FALSE(results.are_kept_by(everywhere));
}

// y = 0.3 b, with a number of the size of 1e54 factor * a added and subtracted, which is zero in float.
std::string lucky_in_float(const std::string& factor) {
  return "program lucky\ninput x value a b\noutput y value 1 1\nsection s s\nin 0\ntmp t0 = x[0] * " + factor +
         "\ntmp t1 = t0 * 1e27\ntmp t2 = t1 * 1e27\ntmp t3 = 0.3 * x[1]\ntmp t4 = t3 + t2\ntmp t5 = t4 - t2\n"
         "return y t5\n";
}

TEST(Accuracy, LuckInOnePrecisionDoesNotCount) {
  const AccurateResults lucky(program(lucky_in_float("1e-50")));
  EXPECT_GT(lucky.error_of_plain().in_double, 1e3);
  EXPECT_LT(lucky.error_of_plain().in_float, 2.0);
  EXPECT_GT(lucky.error_of(program(kRarer)).in_float, 100.0);
  EXPECT_TRUE(lucky.are_kept_by(program(kRarer)));
  EXPECT_FALSE(AccurateResults(program(lucky_in_float("0.0"))).are_kept_by(program(kRarer)));
}

TEST(Accuracy, APrecisionWithoutDigitsIsNoMeasureForTheOther) {
  const AccurateResults results(program(lucky_in_float("1e-46")));
  EXPECT_GT(results.error_of_plain().in_double, 1e7);
  EXPECT_FALSE(results.are_kept_by(program(kRarer)));
}

// The reciprocal of the pivot 3 + x, with a number added and subtracted, and 1e12 times the root of another pivot: the
// larger element hides the digits that the first one loses.
std::string hidden_pivot(const std::string& number) {
  return "program pivot\ninput x value a\noutput y value 2 1\nsection s s\nin 0\ntmp t0 = x[0] + 3.0\ntmp t1 = t0 + " +
         number + "\ntmp t2 = t1 - " + number +
         "\ntmp t3 = 1.0 / t2\ntmp t4 = t0 * 0.3\ntmp t5 = sqrt t4\ntmp t6 = t5 * 1e12\nreturn y t3 t6\n";
}

TEST(Accuracy, PivotsThatLargerElementsHideAreCounted) {
  const AccurateResults results(program(hidden_pivot("2.0")));
  EXPECT_TRUE(results.are_kept_by(program(hidden_pivot("4096.0"))));
  EXPECT_LT(results.error_of(program(hidden_pivot("16777216.0"))).in_float, 8.0);
  EXPECT_FALSE(results.are_kept_by(program(hidden_pivot("16777216.0"))));
}

// If the plain program itself loses pivots, no program is accepted in its place, not even an equal one.
TEST(Accuracy, WherePivotsAreLostNothingTakesThePlaceOfThePlainProgram) {
  const Program plain = program(hidden_pivot("16777216.0"));
  EXPECT_FALSE(AccurateResults(plain).are_kept_by(plain));
}

TEST(Accuracy, WhatOverflowsHasLostAll) {
  const AccurateResults results(program(kSum));
  EXPECT_TRUE(std::isinf(results.error_of(program(detour("1e300"))).in_float));
}

TEST(Accuracy, IsPrintedWithFewDigits) {
  EXPECT_EQ(print({1.26, 12.3}), "1.3 in double, 12 in float");
  EXPECT_EQ(print({123456, std::numeric_limits<double>::infinity()}), "1.2e+05 in double, inf in float");
}

}  // namespace
}  // namespace robcogen::symbolic::accuracy_test
