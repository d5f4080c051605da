// Energies, compared with calculation by hand.
#include <cmath>

#include "algorithm/dynamics/dynamics.h"
#include "hand_robots.h"

namespace robcogen::algorithm::energy_test {
namespace {

using namespace test;

constexpr double kQ1 = 0.4, kQ2 = -1.1, kQd1 = 1.5, kQd2 = 0.25;

TEST(Energy, KineticOfTwoRods) {
  const double both = kQd1 + kQd2, between = kL1 * kQd1 * kL2 * both * std::cos(kQ2);
  const double v1 = kL1 * kQd1 * kL1 * kQd1, v2 = v1 + kL2 * both * kL2 * both + 2 * between;
  expect_near(
      run(kinetic_energy(two_rods(), "f"), {{"q", {kQ1, kQ2}}, {"qd", {kQd1, kQd2}}}), {(kM1 * v1 + kM2 * v2) / 2});
}

TEST(Energy, KineticOfBallAndBead) {
  constexpr double q = 0.8, qd = 2, w = 0.5, v = -1.5;  // the ball turns about z and flies along y
  const double along = qd, across = v + w * q;
  expect_near(
      run(kinetic_energy(ball_and_bead(), "f"), {{"q", {q}}, {"qd", {qd}}, {"base_velocity", {0, 0, w, 0, v, 0}}}),
      {(kBallMoment * w * w + kBall * v * v + kBead * (along * along + across * across)) / 2});
}

// Rods that turn about z keep their height; with gravity along -y, turning does work.
TEST(Energy, PotentialOfTwoRods) {
  const symbolic::Arrays<double> at{{"q", {kQ1, kQ2}}};
  expect_near(run(potential_energy(two_rods(), "f", Loads::standard_gravity), at), {0});
  symbolic::Arrays<double> sideways = at;
  sideways["gravity"] = {0, -2, 0};
  const double height = (kM1 + kM2) * kL1 * std::sin(kQ1) + kM2 * kL2 * std::sin(kQ1 + kQ2);
  expect_near(run(potential_energy(two_rods(), "f", Loads::gravity), sideways), {2 * height});
}

// The potential energy increases with height: m g h.
TEST(Energy, PotentialGrowsWithHeight) {
  model::Description d = model::test::two_links();
  d.joints[0].type = model::JointType::prismatic;
  d.links[0].inertia = model::test::ball(2);
  d.links[1].inertia = model::test::ball(1);
  expect_near(run(potential_energy(built(d), "f", Loads::standard_gravity), {{"q", {0.5, 3}}}), {3 * 9.81 * 0.5});
}

}  // namespace
}  // namespace robcogen::algorithm::energy_test
