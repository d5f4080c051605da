// A step of all joints of a robot with loops, against a step of its coordinates.
#include "robcogen/generic/all_joints.h"

#include <four_bar_leg/four_bar_leg.h>
#include <gtest/gtest.h>

namespace robcogen::test::all_joints_test {
namespace {

using Robot = four_bar_leg::Robot;

// Both start with closed loops, and the forces in the loops replace the dependence of the joints. Each step is of first
// order, so that the difference after a given time is proportional to its length.
double difference(int steps) {
  constexpr double kDuration = 0.05;
  const double h = kDuration / steps;
  State<Robot> state;
  state.q << 0.2, 0.1, -0.3;
  state.qd << 0.5, -1.0, 0.8;
  auto all = all_joints(Robot(), state);
  using Vector = decltype(all)::Vector;
  for (int i = 0; i < steps; ++i) {
    state = integrate(state, Robot::forward_dynamics(state.q, state.qd, Robot::JointState::Zero()), h);
    all = integrate(
        all,
        Robot::loop_constrained_forward_dynamics(
            all.positions, all.velocities, Vector::Zero(), Eigen::Vector2d(2500, 100),
            Eigen::Matrix<double, 1, 1>::Zero()),
        h);
  }
  return (Robot::joint_positions(state.q) - all.positions).norm();
}

TEST(AllJoints, MoveLikeTheCoordinates) {
  const double coarse = difference(200), fine = difference(400);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(coarse, 1e-9);
  EXPECT_NEAR(coarse / fine, 2, 0.2);
}

}  // namespace
}  // namespace robcogen::test::all_joints_test
