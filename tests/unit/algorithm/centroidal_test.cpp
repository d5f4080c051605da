// Centre of mass, its Jacobian and the centroidal momentum matrix, compared with calculation by hand.
#include <cmath>

#include "algorithm/dynamics/dynamics.h"
#include "hand_robots.h"

namespace robcogen::algorithm::centroidal_test {
namespace {

using namespace test;

constexpr double kQ1 = 0.4, kQ2 = -1.1;
const double kC1 = std::cos(kQ1), kS1 = std::sin(kQ1), kC12 = std::cos(kQ1 + kQ2), kS12 = std::sin(kQ1 + kQ2);
constexpr double kM = kM1 + kM2;
const symbolic::Arrays<double> kBent{{"q", {kQ1, kQ2}}};

TEST(Centroidal, CenterOfTwoRods) {
  const std::vector<double> x = {(kM * kL1 * kC1 + kM2 * kL2 * kC12) / kM, (kM * kL1 * kS1 + kM2 * kL2 * kS12) / kM, 0};
  expect_near(run(center_of_mass(two_rods(), "f"), kBent), x);
}

TEST(Centroidal, JacobianOfTwoRods) {
  const std::vector<double> second = {-kM2 * kL2 * kS12 / kM, kM2 * kL2 * kC12 / kM, 0};
  std::vector<double> columns = {-kL1 * kS1 + second[0], kL1 * kC1 + second[1], 0};
  columns.insert(columns.end(), second.begin(), second.end());
  expect_near(run(center_of_mass_jacobian(two_rods(), "f"), kBent), columns);
}

// Two masses about their centre of mass: the angular momentum is that of the reduced mass at their distance.
TEST(Centroidal, MomentumOfTwoRods) {
  const std::vector<double> A = run(centroidal_momentum_matrix(two_rods(), "f"), kBent);
  const std::vector<double> J = run(center_of_mass_jacobian(two_rods(), "f"), kBent);
  const double spin = kM1 * kM2 / kM * kL2 * kL2;  // the second mass turns about the first in both columns
  std::vector<double> expected;
  for (std::size_t k = 0; k < 2; ++k)
    expected.insert(expected.end(), {0, 0, spin, kM * J[3 * k], kM * J[3 * k + 1], 0});
  expect_near(A, expected);
}

TEST(Centroidal, BallAndBead) {
  constexpr double q = 0.8, mass = kBall + kBead, x = kBead * q / mass,
                   spin = kBallMoment + kBall * kBead / mass * q * q;
  const symbolic::Arrays<double> at{{"q", {q}}};
  expect_near(run(center_of_mass(ball_and_bead(), "f"), at), {x, 0, 0});
  expect_near(run(center_of_mass_jacobian(ball_and_bead(), "f"), at), {0, 0, 0, 0, 0, -x,           0, x, 0, 1, 0, 0, 0,
                                                                       1, 0, 0, 0, 1, kBead / mass, 0, 0});
  std::vector<double> A(42);
  A[0] = kBallMoment;
  A[7] = A[14] = spin;
  A[11] = -kBead * q;  // turning about y moves the bead along -z
  A[16] = kBead * q;
  A[21] = A[28] = A[35] = mass;
  A[39] = kBead;
  expect_near(run(centroidal_momentum_matrix(ball_and_bead(), "f"), at), A);
}

// The zeros and ones that a rigid base contributes are literals.
TEST(Centroidal, WhatIsKnownCostsNothing) {
  const symbolic::Program A = centroidal_momentum_matrix(ball_and_bead(), "f");
  for (std::size_t k = 18; k < 36; ++k) EXPECT_EQ(A.outputs[0].values[k].kind, symbolic::Operand::Kind::constant) << k;
}

// A robot that consists only of a fixed base or of massless links has no centre of mass, so the result is zero.
TEST(Centroidal, OfNothingThatMoves) {
  model::Description d;
  d.name = "rock";
  d.base = model::test::link("rock");
  expect_near(run(center_of_mass(built(d), "f"), {}), {0, 0, 0});
  EXPECT_EQ(center_of_mass_jacobian(built(d), "f").outputs[0].columns, 0);
  EXPECT_EQ(centroidal_momentum_matrix(built(d), "f").outputs[0].columns, 0);
}

}  // namespace
}  // namespace robcogen::algorithm::centroidal_test
