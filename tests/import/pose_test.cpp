// Angles of rotations are exact if they can be, and always describe the same rotation.
#include "import/pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

namespace robcogen::import::pose_test {
namespace {

Number decimal(const char* text) {
  return *Number::parse(text);
}

Number pi(std::int64_t num, std::int64_t den = 1) {
  return Number::pi_multiple(num, den);
}

using Angles = std::array<Number, 3>;

const Number kZero;

Angles of_rpy(const Number& roll, const Number& pitch, const Number& yaw) {
  return intrinsic_angles(rotation_of_rpy({roll, pitch, yaw}));
}

void expect_exactly(const Angles& found, const Angles& wanted) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE(found[i] == wanted[i]) << "angle " << i << " is " << print(found[i]) << ", not " << print(wanted[i]);
}

TEST(Pose, KeepsASingleAngleAsItWasGiven) {
  expect_exactly(of_rpy(decimal("0.3"), kZero, kZero), {decimal("0.3"), kZero, kZero});
  expect_exactly(of_rpy(kZero, decimal("2.5"), kZero), {kZero, decimal("2.5"), kZero});
  expect_exactly(of_rpy(kZero, kZero, decimal("-3.1")), {kZero, kZero, decimal("-3.1")});
  // This angle is beyond the range of atan2 and asin.
  expect_exactly(of_rpy(kZero, decimal("-7.25"), kZero), {kZero, decimal("-7.25"), kZero});
}

TEST(Pose, ComposesQuarterTurnsExactly) {
  expect_exactly(of_rpy(pi(1, 2), kZero, pi(1)), {pi(-1, 2), kZero, pi(1)});
  expect_exactly(of_rpy(pi(1), pi(1), pi(1)), {kZero, kZero, kZero});
  const Rotation there = rotation_of_rpy({pi(1, 2), pi(-1, 2), pi(1)});
  expect_exactly(intrinsic_angles(there * inverse(there)), {kZero, kZero, kZero});
  expect_exactly(
      intrinsic_angles(rotation_about(2, pi(1, 12)) * rotation_about(2, pi(5, 12))), {kZero, kZero, pi(1, 2)});
}

TEST(Pose, AddsAnglesAboutOneAxisExactlyThroughQuarterTurns) {
  // Ry(PI/2) Rx(0.1) Ry(-PI/2) is a turn about -z.
  const Rotation r = rotation_about(1, pi(1, 2)) * rotation_about(0, decimal("0.1")) * rotation_about(1, pi(-1, 2)) *
                     rotation_about(2, decimal("0.3"));
  expect_exactly(intrinsic_angles(r), {kZero, kZero, decimal("0.3") - decimal("0.1")});
}

TEST(Pose, DoesNotMakeAnAngleAMultipleOfPi) {
  const Number nearly = decimal("1.5707963267948966"), nearly_half = decimal("3.141592653589793");
  ASSERT_FALSE(nearly.is_pi_multiple());
  expect_exactly(of_rpy(nearly, kZero, kZero), {nearly, kZero, kZero});
  expect_exactly(of_rpy(nearly, kZero, nearly_half), {-nearly, kZero, nearly_half});
  for (const Number& angle : intrinsic_angles(rotation_of_rpy({nearly, nearly, nearly})))
    EXPECT_FALSE(angle.is_pi_multiple() && !angle.is_zero()) << print(angle);
  // An exact quarter turn next to an inexact one stays exact.
  const Angles beside = intrinsic_angles(rotation_of_rpy({nearly, kZero, kZero}) * rotation_about(1, pi(1, 2)));
  expect_exactly(beside, {nearly, pi(1, 2), kZero});
}

TEST(Pose, InGimbalLockLeavesTheCommonAxisToRx) {
  expect_exactly(of_rpy(kZero, pi(1, 2), kZero), {kZero, pi(1, 2), kZero});
  const Angles first = intrinsic_angles(rotation_about(0, decimal("0.2")) * rotation_about(1, pi(1, 2)));
  expect_exactly(first, {decimal("0.2"), pi(1, 2), kZero});
  const Angles last = intrinsic_angles(rotation_about(1, pi(-1, 2)) * rotation_about(2, decimal("0.7")));
  expect_exactly(last, {-decimal("0.7"), pi(-1, 2), kZero});
  const Rotation both =
      rotation_about(0, decimal("0.2")) * rotation_about(1, pi(1, 2)) * rotation_about(2, decimal("0.3"));
  expect_exactly(intrinsic_angles(both), {decimal("0.5"), pi(1, 2), kZero});
}

TEST(Pose, NearGimbalLockKeepsGivenAngles) {
  const auto xyz = [](const char* x, const char* y, const char* z) {
    return rotation_about(0, decimal(x)) * rotation_about(1, decimal(y)) * rotation_about(2, decimal(z));
  };
  for (const char* y : {"1.5707963267948966", "1.570796326", "-1.5707963"})
    expect_exactly(intrinsic_angles(xyz("0.2", y, "0.3")), {decimal("0.2"), decimal(y), decimal("0.3")});
}

TEST(Pose, TurnsZToTheAxis) {
  const Number one = Number::rational(1), none;
  const auto angles = [](const Number& x, const Number& y, const Number& z) {
    return intrinsic_angles(rotation_to_axis({x, y, z}));
  };
  expect_exactly(angles(none, none, one), {none, none, none});
  expect_exactly(angles(none, none, -one), {pi(1), none, none});
  expect_exactly(angles(one, none, none), {none, pi(1, 2), none});
  expect_exactly(angles(-one, none, none), {none, pi(-1, 2), none});
  expect_exactly(angles(none, one, none), {pi(-1, 2), none, none});
  expect_exactly(angles(none, -one, none), {pi(1, 2), none, none});
  // Axes halfway between two others, of any length; two decimals near 1/sqrt(2) are not equal by accident.
  expect_exactly(angles(none, decimal("0.7071"), decimal("0.7071")), {pi(-1, 4), none, none});
  expect_exactly(angles(decimal("2"), none, decimal("-2")), {pi(1), pi(1, 4), none});
  expect_exactly(angles(decimal("2"), decimal("2"), none), {pi(-1, 2), pi(1, 4), none});
}

Eigen::Matrix3d turn(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

Eigen::Matrix3d matrix(const Angles& a) {
  return turn(0, a[0].value()) * turn(1, a[1].value()) * turn(2, a[2].value());
}

// Rounding errors of a few products and sines of doubles.
constexpr double kRounding = 4e-15;

TEST(Pose, HasTheAnglesOfTheSameRotation) {
  const std::vector<Number> angles = {
      pi(1, 2),
      pi(-1, 2),
      pi(1),
      pi(1, 4),
      pi(1, 3),
      pi(-5, 12),
      decimal("0.3"),
      decimal("-1.2"),
      decimal("2.9"),
      decimal("1e-9"),
      decimal("1.57"),
      decimal("1.5707963267948966"),
      decimal("1.570796"),
      decimal("-3.141592653589793"),
      decimal("12.5"),
      decimal("1.57079632679")};
  std::mt19937 engine(5);
  const auto pick = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine); };
  for (int trial = 0; trial < 20000; ++trial) {
    Rotation rotation;
    Eigen::Matrix3d wanted = Eigen::Matrix3d::Identity();
    for (std::size_t turns = 1 + pick(8); turns > 0; --turns) {
      const int axis = static_cast<int>(pick(3));
      const Number& angle = angles[pick(angles.size())];
      const bool is_before = pick(2) == 0;
      const Rotation next = rotation_about(axis, angle);
      rotation = is_before ? next * rotation : rotation * next;
      wanted = is_before ? Eigen::Matrix3d(turn(axis, angle.value()) * wanted) : wanted * turn(axis, angle.value());
      if (pick(4) == 0) rotation = inverse(rotation), wanted = wanted.transpose().eval();
    }
    ASSERT_LT((matrix(intrinsic_angles(rotation)) - wanted).cwiseAbs().maxCoeff(), kRounding) << "trial " << trial;
  }
}

TEST(Pose, OfManyTurnsStaysShortAndRight) {
  Rotation rotation;
  Eigen::Matrix3d wanted = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 300; ++i) {
    rotation = rotation * rotation_about(i % 3, decimal("0.37"));
    wanted = wanted * turn(i % 3, 0.37);
    EXPECT_LE(rotation.turns.size(), 12u);
  }
  constexpr double kRoundingOfAll = 300 * kRounding;
  EXPECT_LT((matrix(intrinsic_angles(rotation)) - wanted).cwiseAbs().maxCoeff(), kRoundingOfAll);
}

TEST(Pose, TurnsZToAnyAxis) {
  std::mt19937 engine(6);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector3d axis(normal(engine), normal(engine), normal(engine));
    const Angles a = intrinsic_angles(rotation_to_axis({Number(axis[0]), Number(axis[1]), Number(axis[2])}));
    ASSERT_LT((matrix(a).col(2) - axis.normalized()).norm(), kRounding) << "trial " << trial;
    ASSERT_TRUE(a[2].is_zero());
  }
}

}  // namespace
}  // namespace robcogen::import::pose_test
