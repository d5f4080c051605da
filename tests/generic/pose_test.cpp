// Poses of a base: the element orders of the functions that make them, gravity, integration and its inverse, compared
// with series in long double.
#include "robcogen/pose.h"

#include <gtest/gtest.h>

#include <random>
#include <type_traits>

#include "poses.h"

namespace robcogen::test::pose_test {
namespace {

using Eigen::Matrix3d, Eigen::Quaterniond, Eigen::Vector3d, Eigen::Vector4d;

constexpr double kRounding = 1e-14;  // some dozens of operations on numbers of about one
constexpr double kPi = 3.14159265358979323846;

// A quarter turn about z: the base's x axis is the world's y axis.
const Matrix3d kQuarterTurn = (Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
const double kHalf = std::sqrt(0.5);
const Vector3d kPosition(0.3, -0.2, 1.5);

TEST(BasePose, NamesOfMakersSayTheOrder) {
  for (const BasePose& pose :
       {BasePose::from_quaternion_wxyz(kHalf, 0, 0, kHalf, kPosition),
        BasePose::from_quaternion_wxyz(-3, 0, 0, -3, kPosition),
        BasePose::from_quaternion_xyzw(0, 0, kHalf, kHalf, kPosition),
        BasePose::from_quaternion(Quaterniond(kHalf, 0, 0, kHalf), kPosition),
        BasePose::from_rotation(kQuarterTurn, kPosition), BasePose::from_rpy(0, 0, kPi / 2, kPosition)}) {
    EXPECT_LT((pose.rotation() - kQuarterTurn).norm(), kRounding);
    EXPECT_LT((pose.to_world_axes(Vector3d::UnitX()) - Vector3d::UnitY()).norm(), kRounding);
    EXPECT_LT((pose.to_base_axes(Vector3d::UnitY()) - Vector3d::UnitX()).norm(), kRounding);
    EXPECT_EQ(pose.position(), kPosition);
  }
  EXPECT_LT(
      (BasePose::from_quaternion_xyzw(1, 2, 3, 4).quaternion_xyzw() * std::sqrt(30.0) - Vector4d(1, 2, 3, 4)).norm(),
      kRounding);
  EXPECT_LT(
      (BasePose::from_quaternion_wxyz(1, 2, 3, 4).quaternion_wxyz() * std::sqrt(30.0) - Vector4d(1, 2, 3, 4)).norm(),
      kRounding);
  EXPECT_LT(
      (BasePose::from_quaternion_wxyz(1, 2, 3, 4).quaternion_xyzw() * std::sqrt(30.0) - Vector4d(2, 3, 4, 1)).norm(),
      kRounding);
}

// URDF: first the roll about the fixed x axis, last the yaw about the fixed z axis.
TEST(BasePose, RollPitchYawTurnAboutFixedAxes) {
  const auto turn = [](const Vector3d& axis, double angle) {
    const Matrix3d W = exponential::cross_matrix<double>(axis);
    return Matrix3d(Matrix3d::Identity() + std::sin(angle) * W + (1 - std::cos(angle)) * W * W);
  };
  const Matrix3d expected = turn(Vector3d::UnitZ(), 0.7) * turn(Vector3d::UnitY(), -0.4) * turn(Vector3d::UnitX(), 2.1);
  EXPECT_LT((BasePose::from_rpy(2.1, -0.4, 0.7).rotation() - expected).norm(), kRounding);
}

TEST(BasePose, RotationsAreReadAndGivenBack) {
  std::mt19937_64 engine(1);
  for (int i = 0; i < 1000; ++i) {
    const BasePose pose = random_pose<double>(engine);
    const Matrix3d R = pose.rotation();
    EXPECT_LT((BasePose::from_rotation(R).rotation() - R).norm(), kRounding);
    EXPECT_LT((R.transpose() * R - Matrix3d::Identity()).norm(), kRounding);
  }
}

TEST(BasePose, WhatIsNotARotationIsNaN) {
  EXPECT_TRUE(BasePose::from_quaternion_wxyz(0, 0, 0, 0).rotation().hasNaN());
  EXPECT_TRUE(BasePose::from_rotation(-kQuarterTurn).rotation().hasNaN()) << "a reflection";
  EXPECT_TRUE(BasePose::from_rotation(1.01 * kQuarterTurn).rotation().hasNaN()) << "a scaled rotation";
  EXPECT_TRUE(BasePose::from_rotation(Matrix3d::Constant(std::nan(""))).rotation().hasNaN());
  EXPECT_FALSE(BasePose::from_rotation(1.0001 * kQuarterTurn).rotation().hasNaN()) << "rounded to four digits";
}

TEST(BasePose, TransformsMapToTheWorld) {
  std::mt19937_64 engine(2);
  const BasePose pose = random_pose<double>(engine);
  const Vector3d point(0.1, 0.2, -0.7), w(1, -2, 3), v(0.5, 0.3, -0.1);
  const Vector3d mapped = pose.rotation() * point + pose.position();
  EXPECT_LT(((pose.homogeneous() * point.homogeneous()).head<3>() - mapped).norm(), kRounding);
  // The linear part is the velocity of the point of the moving body at the world origin, v - w x p.
  const Eigen::Matrix<double, 6, 1> twist = pose.motion_transform() * Twist(w, v).vector();
  const Vector3d at_world_origin = pose.rotation() * v - (pose.rotation() * w).cross(pose.position());
  EXPECT_LT((twist.head<3>() - pose.rotation() * w).norm(), kRounding);
  EXPECT_LT((twist.tail<3>() - at_world_origin).norm(), kRounding);
}

TEST(BasePose, CanBeStoredAnywhere) {
  EXPECT_EQ(alignof(BasePose), alignof(double));
  EXPECT_EQ(sizeof(BasePose), 7 * sizeof(double));
  EXPECT_TRUE(std::is_trivially_copyable_v<BasePose>);
  EXPECT_EQ(BasePose().homogeneous(), Eigen::Matrix4d::Identity());
  static_assert(noexcept(integrate(BasePose(), Twist(), 1.0))&& noexcept(difference(BasePose(), BasePose())));
  static_assert(
      std::is_same_v<decltype(integrate(BasicBasePose<float>(), BasicTwist<float>(), 1e-3)), BasicBasePose<float>>);
}

// ---- Gravity.

TEST(GravityInBase, SaysHowTheBaseIsTurned) {
  constexpr double kTurn = 0.3;
  const double s = 9.81 * std::sin(kTurn), c = 9.81 * std::cos(kTurn);
  struct Case {
    double roll, pitch, yaw;
    Vector3d gravity;
  };
  const Case cases[] = {
      {0, 0, 0, {0, 0, -9.81}},       {0, 0, 1.2, {0, 0, -9.81}},     {kPi, 0, 0, {0, 0, 9.81}},
      {kPi / 2, 0, 0, {0, -9.81, 0}}, {-kPi / 2, 0, 0, {0, 9.81, 0}}, {0, kPi / 2, 0, {9.81, 0, 0}},
      {0, kTurn, 0.5, {s, 0, -c}},    {kTurn, 0, -2, {0, -s, -c}},
  };
  for (const Case& a : cases) {
    const BasePose pose = BasePose::from_rpy(a.roll, a.pitch, a.yaw, kPosition);
    EXPECT_LT((gravity_in_base(pose).vector() - a.gravity).norm(), 10 * kRounding)
        << a.roll << " " << a.pitch << " " << a.yaw;
  }
  const Gravity moon(0, 0, -1.62);
  EXPECT_LT((gravity_in_base(BasePose::from_rpy(kPi, 0, 0), moon).vector() + moon.vector()).norm(), kRounding);
}

// ---- Motion.

TEST(Integrate, IsTheMatrixExponential) {
  std::mt19937_64 engine(3);
  for (const double angle : {0.0, 1e-12, 1e-8, 1e-4, 0.03, 0.9999, 1.0001, 2.0, kPi, 5.0, 12.0}) {
    for (int i = 0; i < 20; ++i) {
      const BasePose pose = random_pose<double>(engine);
      const Twist velocity(angle * random_direction<double>(engine), random_vector<double>(engine));
      const Matrix4 expected = exact_homogeneous(pose) * exact_exponential(velocity);
      const Matrix4 error = integrate(pose, 4.0 * velocity, 0.25).homogeneous().cast<long double>() - expected;
      EXPECT_LT(error.cwiseAbs().maxCoeff(), kRounding) << angle;
    }
  }
}

TEST(Difference, IsTheInverseOfIntegrate) {
  std::mt19937_64 engine(4);
  for (const double angle : {0.0, 1e-300, 1e-160, 1e-12, 1e-8, 1e-4, 0.5, 1.5, 3.0, kPi - 1e-6, kPi - 1e-9}) {
    for (int i = 0; i < 20; ++i) {
      const BasePose pose = random_pose<double>(engine);
      const Twist velocity(angle * random_direction<double>(engine), random_vector<double>(engine));
      const Twist back = difference(pose, integrate(pose, velocity, 1));
      EXPECT_LT((back - velocity).vector().norm(), kRounding) << angle;
    }
  }
}

// From the origin nothing is subtracted, so that small rotations keep their relative precision.
TEST(Difference, KeepsTheDigitsOfSmallTurns) {
  for (const double angle : {1e-12, 1e-100, 1e-150}) {
    const Twist velocity(Vector3d(0, angle, 0), Vector3d::Zero());
    EXPECT_NEAR(difference(BasePose(), integrate(BasePose(), velocity, 1)).angular().y() / angle, 1, kRounding);
  }
}

TEST(Difference, BothSignsOfAQuaternionAreOneOrientation) {
  std::mt19937_64 engine(5);
  for (int i = 0; i < 100; ++i) {
    const BasePose from = random_pose<double>(engine), to = random_pose<double>(engine);
    const Quaterniond q = to.quaternion();
    const BasePose other = BasePose::from_quaternion_wxyz(-q.w(), -q.x(), -q.y(), -q.z(), to.position());
    EXPECT_LT((difference(from, other) - difference(from, to)).vector().norm(), kRounding);
    EXPECT_LE(difference(from, to).angular().norm(), kPi + kRounding);
  }
}

TEST(Difference, OfHalfATurnLeadsThere) {
  const BasePose half = BasePose::from_quaternion_wxyz(0, 0.6, 0, 0.8, kPosition);
  const Twist d = difference(BasePose(), half);
  EXPECT_NEAR(d.angular().norm(), kPi, kRounding);
  EXPECT_LT((integrate(BasePose(), d, 1).homogeneous() - half.homogeneous()).norm(), kRounding);
}

// One turn in a thousand steps, a million steps in all. Without normalisation the length of the quaternion would
// change.
TEST(Integrate, DoesNotDrift) {
  BasePose pose;
  const Twist velocity(Vector3d(2, -1, 2) * (2 * kPi / 3), Vector3d(0.1, 0.2, 0.3));
  for (int i = 0; i < 1000000; ++i) pose = integrate(pose, velocity, 1e-3);
  const Matrix3d R = pose.rotation();
  EXPECT_LT((R.transpose() * R - Matrix3d::Identity()).cwiseAbs().maxCoeff(), kRounding);
  const BasePose exact = integrate(BasePose(), velocity, 1000);  // a thousand whole turns
  EXPECT_LT(difference(exact, pose).vector().norm(), 1e-9);
}

TEST(Integrate, SinglePrecisionKeepsItsDigits) {
  std::mt19937_64 engine(6);
  for (const float angle : {1e-6f, 1e-3f, 0.1f, 1.0f, 3.0f}) {
    const auto pose = random_pose<float>(engine);
    const BasicTwist<float> velocity(angle * random_direction<float>(engine), random_vector<float>(engine));
    const auto back = difference(pose, integrate(pose, velocity, 1));
    EXPECT_LT((back - velocity).vector().norm(), 1e-5f) << angle;
  }
}

}  // namespace
}  // namespace robcogen::test::pose_test
