// Derivatives of poses, and accelerations, compared with finite differences in long double.
#include <gtest/gtest.h>

#include "poses.h"

namespace robcogen::test::pose_derivatives_test {
namespace {

using Real = long double;
using Pose = BasicBasePose<Real>;
using Velocity = BasicTwist<Real>;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Vector6 = Eigen::Matrix<Real, 6, 1>;
using Matrix6 = Eigen::Matrix<Real, 6, 6>;

constexpr Real kStep = 1e-6L;
// Error of central differences: the square of the step, and the rounding of long double divided by the step.
constexpr Real kDifference = 1e-11L;
constexpr Real kAngles[] = {0, 1e-9L, 1e-4L, 0.3L, 0.999L, 1.001L, 2, 3};

// Column k is the derivative of function(change), a pose, with respect to element k of the change, in coordinates of
// function(0).
template <class Function>
Matrix6 derivative_of_pose(const Function& function) {
  Matrix6 result;
  for (int k = 0; k < 6; ++k) {
    const Vector6 change = kStep * Vector6::Unit(k);
    const Pose at = function(Velocity());
    const Velocity up = difference(at, function(Velocity(change))), down = difference(at, function(Velocity(-change)));
    result.col(k) = (up - down).vector() / (2 * kStep);
  }
  return result;
}

template <class Function>
Matrix6 derivative_of_twist(const Function& function) {
  Matrix6 result;
  for (int k = 0; k < 6; ++k) {
    const Vector6 change = kStep * Vector6::Unit(k);
    result.col(k) = (function(Velocity(change)) - function(Velocity(-change))).vector() / (2 * kStep);
  }
  return result;
}

Velocity random_velocity(std::mt19937_64& engine, Real angle) {
  return Velocity(angle * random_direction<Real>(engine), random_vector<Real>(engine));
}

TEST(PoseDerivatives, OfIntegrate) {
  std::mt19937_64 engine(11);
  constexpr Real kDt = 0.5L;
  for (const Real angle : kAngles) {
    SCOPED_TRACE(static_cast<double>(angle));
    const Pose pose = random_pose<Real>(engine);
    const Velocity velocity = (1 / kDt) * random_velocity(engine, angle);
    const auto exact = integrate_derivatives(velocity, kDt);
    const Matrix6 by_pose =
        derivative_of_pose([&](const Velocity& d) { return integrate(integrate(pose, d, 1), velocity, kDt); });
    const Matrix6 by_velocity =
        derivative_of_pose([&](const Velocity& d) { return integrate(pose, velocity + d, kDt); });
    const Pose at = integrate(pose, velocity, kDt);
    const Velocity by_dt = (1 / kStep) * difference(at, integrate(pose, velocity, kDt + kStep));
    EXPECT_LT((exact.d_pose - by_pose).norm(), kDifference);
    EXPECT_LT((exact.d_base_velocity - by_velocity).norm(), kDifference);
    EXPECT_LT((exact.d_dt - by_dt).vector().norm(), kDifference);
  }
}

TEST(PoseDerivatives, OfDifference) {
  std::mt19937_64 engine(12);
  for (const Real angle : kAngles) {
    SCOPED_TRACE(static_cast<double>(angle));
    const Pose from = random_pose<Real>(engine), to = integrate(from, random_velocity(engine, angle), 1);
    const auto exact = difference_derivatives(from, to);
    const Matrix6 by_from =
        derivative_of_twist([&](const Velocity& d) { return difference(integrate(from, d, 1), to); });
    const Matrix6 by_to = derivative_of_twist([&](const Velocity& d) { return difference(from, integrate(to, d, 1)); });
    EXPECT_LT((exact.d_from - by_from).norm(), kDifference);
    EXPECT_LT((exact.d_to - by_to).norm(), kDifference);
  }
}

TEST(PoseDerivatives, InDoubleHaveTheDigitsOfLongDouble) {
  std::mt19937_64 engine(13);
  for (const double angle : {1e-9, 1e-3, 0.05, 0.99, 1.01, 3.0}) {
    const Twist twist(angle * random_direction<double>(engine), random_vector<double>(engine));
    const Velocity same(twist.vector().cast<Real>());
    const auto ours = integrate_derivatives(twist, 1);
    const auto exact = integrate_derivatives(same, 1);
    EXPECT_LT((ours.d_base_velocity.cast<Real>() - exact.d_base_velocity).norm(), 1e-14L) << angle;
    EXPECT_LT((ours.d_pose.cast<Real>() - exact.d_pose).norm(), 1e-14L) << angle;
  }
}

// The acceleration of the origin is the derivative of its velocity in world axes.
TEST(Accelerations, ClassicalIsOfTheOrigin) {
  std::mt19937_64 engine(14);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = random_pose<Real>(engine);
    const Velocity velocity = random_velocity(engine, 2);
    const BasicSpatialAcceleration<Real> acceleration(random_velocity(engine, 3).vector());
    const auto classical = classical_from_spatial(acceleration, velocity);
    const auto velocity_after = [&](Real t) -> Vector3 {
      const Vector6 then = velocity.vector() + t * acceleration.vector();
      return integrate(pose, velocity, t).to_world_axes(then.tail<3>());
    };
    const Vector3 expected = (velocity_after(kStep) - velocity_after(-kStep)) / (2 * kStep);
    EXPECT_LT((pose.to_world_axes(classical.linear()) - expected).norm(), 10 * kDifference);
    EXPECT_EQ(classical.angular(), acceleration.angular());
    EXPECT_LT((spatial_from_classical(classical, velocity) - acceleration).vector().norm(), 1e-17L);
  }
}

}  // namespace
}  // namespace robcogen::test::pose_derivatives_test
