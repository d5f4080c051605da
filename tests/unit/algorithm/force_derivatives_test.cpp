// Derivatives of inverse dynamics, compared with calculation by hand.
#include <cmath>

#include "algorithm/dynamics/dynamics.h"
#include "hand_robots.h"

namespace robcogen::algorithm::force_derivatives_test {
namespace {

using namespace test;
using Arrays = symbolic::Arrays<double>;
using Values = std::vector<double>;

Arrays results(const symbolic::Program& program, const Arrays& inputs) {
  EXPECT_EQ(symbolic::verify(program), "");
  return symbolic::interpret(program, inputs);
}

// Two rods under gravity along y: tau = H(q2) qdd + h(q2, qd) + gravity, differentiated term by term.
TEST(InverseDynamicsDerivatives, OfTwoRods) {
  constexpr double q1 = 0.4, q2 = -1.1, qd1 = 1.5, qd2 = 0.25, qdd1 = -0.75, qdd2 = 2, g = 9.5;
  const Arrays found = results(
      inverse_dynamics_derivatives(two_rods(), "f", Loads::gravity),
      {{"q", {q1, q2}}, {"qd", {qd1, qd2}}, {"qdd", {qdd1, qdd2}}, {"gravity", {0, -g, 0}}});
  const double c = kM2 * kL1 * kL2 * std::cos(q2), s = kM2 * kL1 * kL2 * std::sin(q2);
  const double fall1 = (kM1 + kM2) * kL1 * g, fall2 = kM2 * kL2 * g;
  const double H22 = kM2 * kL2 * kL2, H12 = H22 + c, H11 = (kM1 + kM2) * kL1 * kL1 + H22 + 2 * c;
  expect_near(
      found.at("tau"),
      {H11 * qdd1 + H12 * qdd2 - s * (2 * qd1 * qd2 + qd2 * qd2) + fall1 * std::cos(q1) + fall2 * std::cos(q1 + q2),
       H12 * qdd1 + H22 * qdd2 + s * qd1 * qd1 + fall2 * std::cos(q1 + q2)});
  const double by_sum = -fall2 * std::sin(q1 + q2);
  expect_near(
      found.at("d_q"),
      {-fall1 * std::sin(q1) + by_sum, by_sum, -2 * s * qdd1 - s * qdd2 - c * (2 * qd1 * qd2 + qd2 * qd2) + by_sum,
       -s * qdd1 + c * qd1 * qd1 + by_sum});
  expect_near(found.at("d_qd"), {-2 * s * qd2, 2 * s * qd1, -2 * s * (qd1 + qd2), 0});
  expect_near(found.at("d_qdd"), {H11, H12, H12, H22});
}

// At rest, with gravity g along -x. The bead on the ball's x axis carries its weight along the wire at any position; if
// the base turns about y, the weight gets a component across the wire.
TEST(InverseDynamicsDerivatives, OfBallAndBeadAtRest) {
  constexpr double q = 0.8, g = 9.5, m = kBead, mass = kBall + kBead;
  const Arrays found = results(
      inverse_dynamics_derivatives(ball_and_bead(), "f", Loads::gravity), {{"q", {q}},
                                                                           {"qd", {0}},
                                                                           {"qdd", {0}},
                                                                           {"base_velocity", Values(6)},
                                                                           {"base_acceleration", Values(6)},
                                                                           {"gravity", {-g, 0, 0}}});
  expect_near(found.at("tau"), {m * g});
  expect_near(found.at("base_wrench"), {0, 0, 0, mass * g, 0, 0});
  expect_near(found.at("d_q"), Values(7));
  expect_near(found.at("d_qdd"), {0, 0, 0, m, 0, 0, m});
  // A small turn changes gravity to g - turn x g: about y it tips towards -z, about z towards +y.
  Values by_rotation(21);
  by_rotation[7 + 1] = -m * q * g;
  by_rotation[7 + 5] = mass * g;
  by_rotation[14 + 2] = -m * q * g;
  by_rotation[14 + 4] = -mass * g;
  expect_near(found.at("d_base_rotation"), by_rotation);
}

// Coriolis forces are quadratic in the velocities, d_qdd is the joint-space inertia matrix, and gravity has a
// potential.
TEST(InverseDynamicsDerivatives, KeepIdentities) {
  const model::KinematicTree tree = two_rods();
  const Values q = {0.4, -1.1}, qd = {1.5, 0.25}, rest = {0, 0}, gravity = {3, -9.5, 1};
  const symbolic::Program p = inverse_dynamics_derivatives(tree, "f", Loads::gravity);
  const Arrays moving = results(p, {{"q", q}, {"qd", qd}, {"qdd", {2, -1}}, {"gravity", gravity}});
  const Values& d_qd = moving.at("d_qd");
  const Values coriolis = run(coriolis_forces(tree, "f"), {{"q", q}, {"qd", qd}});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(d_qd[i] * qd[0] + d_qd[2 + i] * qd[1], 2 * coriolis[i], kByHand);
  expect_near(moving.at("d_qdd"), run(joint_space_inertia(tree, "f"), {{"q", q}}));
  const Arrays still = results(p, {{"q", q}, {"qd", rest}, {"qdd", rest}, {"gravity", gravity}});
  EXPECT_NEAR(still.at("d_q")[1], still.at("d_q")[2], kByHand);
}

// With a fixed base, branches do not affect each other.
TEST(InverseDynamicsDerivatives, StructuralZerosAreLiteral) {
  model::Description d = model::test::two_links();
  d.base.children = {{"one", "a", {}, {}}, {"two", "b", {}, {}}};
  d.links[0].children.clear();
  const symbolic::Program p = inverse_dynamics_derivatives(built(d), "f", Loads::gravity);
  for (std::size_t block = 1; block < p.outputs.size(); ++block)
    for (const std::size_t off_diagonal : {1U, 2U})
      EXPECT_TRUE(symbolic::is_constant(p.outputs[block].values[off_diagonal]));
}

}  // namespace
}  // namespace robcogen::algorithm::force_derivatives_test
