// The checks of transforms without a robot find faults: in tables written by hand, correct at first, then with one
// fault at a time.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "robcogen/reference/check_transforms.h"

namespace robcogen::reference::transforms_test {
namespace {

using reflection::Amount;
using reflection::Factor;
using reflection::ProductOfFactors;

// S_X_E = Rz(-2 q) Tx(l), and its inverse.
constexpr Factor kThere[] = {{true, 2}, {false, 0}};
constexpr Factor kBack[] = {{false, 0}, {true, 2}};

void amounts_there(const Amount* p, const Amount* v, Amount* amounts) noexcept {
  amounts[0] = -(Amount(2.0) * v[0]);
  amounts[1] = p[0];
}
void amount_of_turn(const Amount*, const Amount* v, Amount* amounts) noexcept {
  amounts[0] = -(Amount(2.0) * v[0]);
}
void amounts_back(const Amount* p, const Amount* v, Amount* amounts) noexcept {
  amounts[0] = -p[0];
  amounts[1] = Amount(2.0) * v[0];
}

Eigen::Matrix4d pose(double angle, double length) {
  return (Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(length, 0, 0)).matrix();
}

Eigen::Matrix<double, 6, 6> spatial(const Eigen::Matrix4d& X, bool motion) {
  const Eigen::Matrix3d R = X.topLeftCorner<3, 3>();
  Eigen::Matrix3d moment;
  for (int k = 0; k < 3; ++k) moment.col(k) = X.topRightCorner<3, 1>().cross(R.col(k));
  Eigen::Matrix<double, 6, 6> result = Eigen::Matrix<double, 6, 6>::Zero();
  result.topLeftCorner<3, 3>() = result.bottomRightCorner<3, 3>() = R;
  (motion ? result.bottomLeftCorner<3, 3>() : result.topRightCorner<3, 3>()) = moment;
  return result;
}

Eigen::Matrix4d there(const double* p, const double* v) noexcept {
  return pose(-2 * v[0], p[0]);
}
Eigen::Matrix4d back(const double* p, const double* v) noexcept {
  return there(p, v).inverse();
}
Eigen::Matrix4d other_sign(const double* p, const double* v) noexcept {
  return pose(2 * v[0], p[0]);
}
Eigen::Matrix4d not_a_number(const double*, const double*) noexcept {
  return Eigen::Matrix4d::Constant(std::nan(""));
}

template <Eigen::Matrix4d (*X)(const double*, const double*) noexcept, bool motion>
Eigen::Matrix<double, 6, 6> form(const double* p, const double* v) noexcept {
  return spatial(X(p, v), motion);
}

constexpr ProductOfFactors kRight = {"S_X_E",           0, 1, {kThere, 2}, amounts_there, there, form<there, true>,
                                     form<there, false>};
constexpr ProductOfFactors kInverse = {"E_X_S",          1, 0, {kBack, 2}, amounts_back, back, form<back, true>,
                                       form<back, false>};

// The number of failures of a table of these two transforms.
int failures(const ProductOfFactors& first, const ProductOfFactors& second) {
  const ProductOfFactors table[] = {first, second};
  return check_transforms({"test", 1, 1, 2, {table, 2}}, 1, 5).failures();
}

TEST(ReferenceTransforms, AcceptWhatIsRight) {
  EXPECT_EQ(failures(kRight, kInverse), 0);
}

TEST(ReferenceTransforms, FindOneSlip) {
  ProductOfFactors wrong = kRight;
  wrong.homogeneous = other_sign;
  EXPECT_GT(failures(wrong, kInverse), 0);
  wrong.homogeneous = not_a_number;
  EXPECT_GT(failures(wrong, kInverse), 0);
  wrong = kRight;
  wrong.motion = form<there, false>;
  EXPECT_GT(failures(wrong, kInverse), 0);
  wrong = kRight;
  wrong.force = form<there, true>;
  EXPECT_GT(failures(wrong, kInverse), 0);
  // A function of the other transform.
  EXPECT_GT(
      failures({"S_X_E", 0, 1, {kThere, 2}, amounts_there, back, form<back, true>, form<back, false>}, kInverse), 0);
  // A factor left out.
  EXPECT_GT(
      failures({"S_X_E", 0, 1, {kThere, 1}, amount_of_turn, there, form<there, true>, form<there, false>}, kInverse),
      0);
}

TEST(ReferenceTransforms, FindTransformsThatNothingWasComparedFor) {
  // The root of a negative length: no sample gives a number.
  const auto root = [](const Amount* p, const Amount*, Amount* amounts) noexcept { amounts[0] = sqrt(-p[0]); };
  static constexpr Factor kFactor[] = {{false, 0}};
  EXPECT_GT(failures({"S_X_E", 0, 1, {kFactor, 1}, root, there, form<there, true>, form<there, false>}, kInverse), 0);
}

TEST(ReferenceTransforms, AmountsKnowTheLargestMagnitudeOnTheWay) {
  const Amount difference = Amount(1e6) - Amount(999999.0);
  EXPECT_EQ(difference.value, 1.0L);
  EXPECT_EQ(difference.size, 1e6L);
  const Amount all = (sin(Amount(0.5)) + cos(Amount(0.25)) - Amount(0.75)) / sqrt(Amount(9.0)) * Amount(2.0);
  EXPECT_NEAR(static_cast<double>(all.value), (std::sin(0.5) + std::cos(0.25) - 0.75) / 3 * 2, 1e-15);
  EXPECT_EQ(all.size, 9.0L);
  EXPECT_TRUE(std::isnan(static_cast<double>(sqrt(Amount(-1.0)).size)));
}

}  // namespace
}  // namespace robcogen::reference::transforms_test
