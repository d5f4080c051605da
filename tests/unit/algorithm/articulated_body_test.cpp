// Forward dynamics by articulated bodies: a double pendulum and a bead on a spinning ball, by hand.
#include "algorithm/dynamics/articulated_body.h"

#include <cmath>

#include "hand_robots.h"

namespace robcogen::algorithm::articulated_body_test {
namespace {

using namespace test;
using symbolic::Role;

// Runs the algorithm alone, without a formulation; returns {qdd, base_acceleration}.
symbolic::Arrays<double> run_articulated(const model::KinematicTree& tree, const symbolic::Arrays<double>& inputs) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::force, State::base_velocity});
  const LoadInputs load(trace, Loads::gravity_and_external);
  const TracedRobot robot(trace, in.q);
  const ForwardMotion motion = by_articulated_bodies(robot, in, load);
  trace.output("qdd", Role::joint_acceleration, motion.qdd);
  trace.output("base_acceleration", Role::base_acceleration, motion.base_acceleration);
  const symbolic::Program program = trace.program("articulated");
  EXPECT_EQ(verify(program), "");
  return symbolic::interpret<double>(program, inputs);
}

// Accelerations of a few m/s^2, computed with one or two divisions.
void expect_accelerations(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-12) << "element " << k;
}

// Lagrange's equations of two point masses in a plane, solved by Cramer's rule.
TEST(ArticulatedBody, DoublePendulum) {
  const double q1 = 0.4, q2 = -1.1, qd1 = 1.5, qd2 = 0.25, tau1 = 2, tau2 = -0.7, gx = 3, gy = -9;
  const double near = (kM1 + kM2) * kL1 * kL1, far = kM2 * kL2 * kL2, both = kM2 * kL1 * kL2;
  const double h11 = near + far + 2 * both * std::cos(q2), h12 = far + both * std::cos(q2), h22 = far;
  const double torque2 = kM2 * kL2 * (gy * std::cos(q1 + q2) - gx * std::sin(q1 + q2));
  const double torque1 = (kM1 + kM2) * kL1 * (gy * std::cos(q1) - gx * std::sin(q1)) + torque2;
  const double b1 = tau1 + torque1 + both * std::sin(q2) * (2 * qd1 * qd2 + qd2 * qd2);
  const double b2 = tau2 + torque2 - both * std::sin(q2) * qd1 * qd1;
  const double determinant = h11 * h22 - h12 * h12;

  const auto found = run_articulated(
      two_rods(), {{"q", {q1, q2}}, {"qd", {qd1, qd2}}, {"tau", {tau1, tau2}}, {"gravity", {gx, gy, 5}}});
  expect_accelerations(found.at("qdd"), {(h22 * b1 - h12 * b2) / determinant, (h11 * b2 - h12 * b1) / determinant});
}

// A force on the second mass, perpendicular to its rod, has the effect of the equivalent joint forces.
TEST(ArticulatedBody, AnExternalForceActsAsItsJointForcesDo) {
  const double q1 = 0.4, q2 = -1.1, push = 1.25;
  std::vector<double> wrenches(18, 0.0);
  wrenches[2 * 6 + 2] = push * kL2;  // moment about the origin of link two
  wrenches[2 * 6 + 4] = push;
  const double tau1 = push * (kL2 + kL1 * std::cos(q2)), tau2 = push * kL2;
  const auto by_wrench = run_articulated(two_rods(), {{"q", {q1, q2}}, {"external", wrenches}});
  const auto by_joints = run_articulated(two_rods(), {{"q", {q1, q2}}, {"tau", {tau1, tau2}}});
  EXPECT_GT(std::abs(by_joints.at("qdd")[1]), 0.1);
  expect_accelerations(by_wrench.at("qdd"), by_joints.at("qdd"));
}

// Newton's law for the relative motion of two bodies: the reduced mass moves in polar coordinates about the ball.
TEST(ArticulatedBody, ABeadOnASpinningBall) {
  const double r = 0.6, rate = -0.8, spin = 2.5, force = 1.75;
  const double reduced = kBall * kBead / (kBall + kBead);
  const double qdd = force / reduced + r * spin * spin;
  const double across = 2 * rate * spin * kBallMoment / (kBallMoment + reduced * r * r);  // 2 r' w + r w'
  const double share = -kBead / (kBall + kBead);
  const double slowing = -r * reduced * across / kBallMoment;

  const auto found = run_articulated(
      ball_and_bead(), {{"q", {r}}, {"qd", {rate}}, {"tau", {force}}, {"base_velocity", {0, 0, spin, 0, 0, 0}}});
  expect_accelerations(found.at("qdd"), {qdd});
  expect_accelerations(
      found.at("base_acceleration"), {0, 0, slowing, share * (qdd - r * spin * spin), share * across, 0});
}

}  // namespace
}  // namespace robcogen::algorithm::articulated_body_test
