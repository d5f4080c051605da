// Jacobians in three references, their derivatives, velocities and accelerations of a rod's end, compared with
// calculation by hand.
#include <algorithm>
#include <cmath>

#include "algorithm/kinematics/kinematics.h"
#include "hand_robots.h"

namespace robcogen::algorithm::frame_motion_test {
namespace {

using namespace test;

constexpr double kQ1 = 0.4, kQ2 = -1.1, kQd1 = 1.5, kQd2 = 0.25, kQdd1 = -2, kQdd2 = 3;
const double kX = kL1 * std::cos(kQ1), kY = kL1 * std::sin(kQ1);  // of the second rod's origin

class FrameMotion : public testing::Test {
 protected:
  model::KinematicTree tree = two_rods();
  model::FramePair forth{*tree.find_frame("fr_base"), *tree.find_frame("fr_two")};
  model::FramePair back{forth.right, forth.left};

  template <class... Arguments>
  std::vector<double> value(
      symbolic::Program (*f)(const model::KinematicTree&, const model::FramePair&, const std::string&, Arguments...),
      const model::FramePair& pair,
      Arguments... arguments) const {
    const symbolic::Program p = f(tree, pair, "f", arguments...);
    symbolic::Arrays<double> inputs{{"q", {kQ1, kQ2}}};
    if (p.inputs.size() > 1) inputs["qd"] = {kQd1, kQd2};
    if (p.inputs.size() > 2) inputs["qdd"] = {kQdd1, kQdd2};
    return run(p, inputs);
  }
};

TEST_F(FrameMotion, JacobianInLeftAxes) {
  expect_near(value(geometric_jacobian, forth, JacobianReference::in_left), {0, 0, 1, -kY, kX, 0, 0, 0, 1, 0, 0, 0});
}

TEST_F(FrameMotion, JacobianInTargetAxes) {
  expect_near(
      value(geometric_jacobian, forth, JacobianReference::in_target),
      {0, 0, 1, kL1 * std::sin(kQ2), kL1 * std::cos(kQ2), 0, 0, 0, 1, 0, 0, 0});
}

// When the elbow moves, so does the point of the second rod that coincides with the base origin.
TEST_F(FrameMotion, SpatialJacobian) {
  expect_near(value(geometric_jacobian, forth, JacobianReference::spatial), {0, 0, 1, 0, 0, 0, 0, 0, 1, kY, -kX, 0});
}

// RelativeMotion from the rod, the base moves in the opposite direction; in the base's axes, the columns are the
// negated columns of the spatial Jacobian in reverse order.
TEST_F(FrameMotion, ReferencesOfTheWayBack) {
  std::vector<double> there = value(geometric_jacobian, forth, JacobianReference::spatial);
  std::vector<double> columns;
  for (const std::size_t column : {1u, 0u})
    for (std::size_t k = 0; k < 6; ++k) columns.push_back(-there[6 * column + k]);
  expect_near(value(geometric_jacobian, back, JacobianReference::in_target), columns);
}

TEST_F(FrameMotion, JacobianDerivative) {
  expect_near(value(jacobian_derivative, forth), {0, 0, 0, -kX * kQd1, -kY * kQd1, 0, 0, 0, 0, 0, 0, 0});
}

// Only the centripetal acceleration of the elbow remains.
TEST_F(FrameMotion, JacobianDerivativeTimesVelocity) {
  expect_near(value(jacobian_derivative_times_velocity, forth), {0, 0, 0, -kX * kQd1 * kQd1, -kY * kQd1 * kQd1, 0});
}

TEST_F(FrameMotion, Velocity) {
  expect_near(value(frame_velocity, forth), {0, 0, kQd1 + kQd2, kY * kQd2, -kX * kQd2, 0});
}

TEST_F(FrameMotion, Acceleration) {
  expect_near(
      value(frame_acceleration, forth),
      {0, 0, kQdd1 + kQdd2, kX * kQd1 * kQd2 + kY * kQdd2, kY * kQd1 * kQd2 - kX * kQdd2, 0});
}

}  // namespace
}  // namespace robcogen::algorithm::frame_motion_test
