// The Coriolis matrix, compared with calculation by hand.
#include "algorithm/dynamics/dynamics.h"

#include <cmath>

#include "hand_robots.h"

namespace robcogen::algorithm::coriolis_matrix_test {
namespace {

using namespace test;

// The textbook matrix from Christoffel symbols (Spong, Hutchinson, Vidyasagar 2006, sec. 7.4).
TEST(CoriolisMatrix, OfTwoRods) {
  constexpr double q2 = -1.1, qd1 = 1.5, qd2 = 0.25;
  const double h = -kM2 * kL1 * kL2 * std::sin(q2);
  expect_near(
      run(coriolis_matrix(two_rods(), "f"), {{"q", {0.4, q2}}, {"qd", {qd1, qd2}}}),
      {h * qd2, -h * qd1, h * (qd1 + qd2), 0});
}

// The ball turns at w about z and flies at v along y; the bead is at q and moves at qd. Each column is the rate of
// change of the motion that a unit coordinate velocity causes, weighted by the inertia that each coordinate moves.
TEST(CoriolisMatrix, OfBallAndBead) {
  constexpr double q = 0.8, qd = 2, w = 0.5, v = -1.5, m = kBead, mass = kBall + kBead;
  const std::vector<double> C =
      run(coriolis_matrix(ball_and_bead(), "f"), {{"q", {q}}, {"qd", {qd}}, {"base_velocity", {0, 0, w, 0, v, 0}}});
  const auto c = [&](std::size_t row, std::size_t column) { return C[row + 7 * column]; };
  constexpr std::size_t kWz = 2, kVx = 3, kVy = 4, kQ = 6;
  EXPECT_NEAR(c(kWz, kWz), m * q * qd, kByHand);  // the bead moves outwards
  EXPECT_NEAR(c(kVx, kWz), -m * q * w, kByHand);  // centripetal
  EXPECT_NEAR(c(kVy, kWz), m * qd, kByHand);
  EXPECT_NEAR(c(kQ, kWz), -m * q * w, kByHand);
  EXPECT_NEAR(c(kWz, kVx), m * q * w, kByHand);  // the axes turn while the velocity is constant
  EXPECT_NEAR(c(kVy, kVx), mass * w, kByHand);
  EXPECT_NEAR(c(kVx, kVy), -mass * w, kByHand);
  EXPECT_NEAR(c(kQ, kVy), -m * w, kByHand);
  EXPECT_NEAR(c(kWz, kQ), m * q * w, kByHand);
  EXPECT_NEAR(c(kVy, kQ), m * w, kByHand);
  EXPECT_NEAR(c(kQ, kQ), 0, kByHand);
}

// With a fixed base, branches are not affected by each other's velocities.
TEST(CoriolisMatrix, StructuralZerosAreLiteral) {
  model::Description d = model::test::two_links();
  d.base.children = {{"one", "a", {}, {}}, {"two", "b", {}, {}}};
  d.links[0].children.clear();
  const symbolic::Program p = coriolis_matrix(built(d), "f");
  for (const symbolic::Operand& value : p.outputs[0].values) EXPECT_EQ(value.kind, symbolic::Operand::Kind::constant);
}

}  // namespace
}  // namespace robcogen::algorithm::coriolis_matrix_test
