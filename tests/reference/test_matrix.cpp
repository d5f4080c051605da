// The dense matrices on which the reference is built, and the bookkeeping of checks.
#include <gtest/gtest.h>

#include <limits>

#include "robcogen/reference/checks.h"

namespace robcogen::reference::matrix_test {
namespace {

constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();
constexpr Tolerance kTolerance{"kTolerance", 1e-3, "a test"};

Matrix<double> two_by_two(double a, double b, double c, double d) {
  Matrix<double> m(2, 2);
  m(0, 0) = a;
  m(0, 1) = b;
  m(1, 0) = c;
  m(1, 1) = d;
  return m;
}

TEST(ReferenceMatrix, MultipliesRowsByColumns) {
  const Matrix<double> product = two_by_two(1, 2, 3, 4) * two_by_two(5, 6, 7, 8);
  EXPECT_EQ(largest(product - two_by_two(19, 22, 43, 50)), 0);
  EXPECT_EQ(largest(transpose(product) - two_by_two(19, 43, 22, 50)), 0);
}

TEST(ReferenceMatrix, SolveNeedsAPivot) {
  const Vector<double> x = solve(two_by_two(0, 2, 3, 4), Vector<double>{6, 18});
  EXPECT_DOUBLE_EQ(x(0), 2);
  EXPECT_DOUBLE_EQ(x(1), 3);
}

TEST(ReferenceMatrix, SolveOfASingularMatrixIsNoNumber) {
  EXPECT_FALSE(std::isfinite(largest(solve(two_by_two(1, 2, 2, 4), Vector<double>{1, 1}))));
}

TEST(ReferenceMatrix, PositiveDefinite) {
  EXPECT_TRUE(positive_definite(two_by_two(2, 1, 1, 2)));
  EXPECT_FALSE(positive_definite(two_by_two(1, 2, 2, 1)));
  EXPECT_FALSE(positive_definite(two_by_two(1, 1, 1, 1)));
  EXPECT_TRUE(positive_definite(Matrix<double>(0, 0)));
}

TEST(ReferenceMatrix, LargestKeepsWhatIsNoNumber) {
  EXPECT_EQ(largest(Vector<Real>{1, -3, 2}), 3);
  EXPECT_TRUE(std::isnan(largest(Vector<Real>{1, kNaN, 2})));
  EXPECT_EQ(largest(Vector<Real>()), 0);
}

TEST(ReferenceChecks, RelativeErrorIsThatOfTheWorstElement) {
  EXPECT_NEAR(static_cast<double>(relative_error({1.1L, 20}, {1, 20}, {1, 20})), 0.1, 1e-3);
  EXPECT_EQ(relative_error({1, 2}, {1, 2}, {0, 0}), 0);
  EXPECT_TRUE(std::isinf(relative_error({1, 2}, {1, 3}, {0, 0})));
  EXPECT_TRUE(std::isnan(relative_error({kNaN, 2}, {1, 2}, {1, 1})));
}

TEST(ReferenceChecks, CountsFailuresOfTheLargestErrors) {
  Checks checks;
  checks.record("passes", kTolerance, 1e-4L, 0);
  checks.record("fails once", kTolerance, 1e-2L, 0);
  checks.record("fails once", kTolerance, 1e-5L, 1);
  checks.record("no number", kTolerance, kNaN, 0);
  checks.record("no number", kTolerance, 0, 1);
  EXPECT_EQ(checks.size(), 3);
  EXPECT_EQ(checks.failures(), 2);
  const std::string text = checks.failure_report();
  EXPECT_EQ(text.find("passes"), std::string::npos);
  EXPECT_NE(text.find("FAIL  fails once"), std::string::npos);
  EXPECT_NE(text.find("FAIL  no number"), std::string::npos);
  EXPECT_NE(text.find("kTolerance"), std::string::npos);
  EXPECT_NE(checks.report().find("ok    passes"), std::string::npos);
}

}  // namespace
}  // namespace robcogen::reference::matrix_test
