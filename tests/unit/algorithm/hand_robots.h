// Small robots whose mechanics can be computed by hand.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "model/descriptions.h"
#include "symbolic/interpret.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"

namespace robcogen::algorithm::test {

// A few rounding errors of numbers of order 1.
inline constexpr double kByHand = 1e-14;

inline model::KinematicTree built(const model::Description& d) {
  Diagnostics diagnostics;
  const auto tree = model::build(d, diagnostics);
  EXPECT_TRUE(tree) << diagnostics.render();
  return tree.value_or(model::KinematicTree());
}

inline model::Inertia point_mass_on_x(double mass, double x) {
  model::Inertia i;
  i.mass = model::Quantity(mass);
  i.com[0] = model::Quantity(x);
  i.iyy = i.izz = model::Quantity(mass * x * x);
  return i;
}

// Point masses m1 and m2 on massless rods that turn about the base's z axis; at q = 0 they stretch along its x axis.
// The base is heavy and fixed, so its mass must have no effect.
inline constexpr double kM1 = 2.0, kL1 = 0.75, kM2 = 0.5, kL2 = 1.25;  // the masses are at the ends of their rods

inline model::KinematicTree two_rods() {
  model::Description d = model::test::two_links();
  d.base.inertia = model::test::ball(100, 1);
  d.links[0].inertia = point_mass_on_x(kM1, kL1);
  d.links[1].inertia = point_mass_on_x(kM2, kL2);
  d.joints[1].placement.translation[0] = model::Quantity(kL1);
  return built(d);
}

// A floating ball and a point mass that slides along the ball's x axis, at distance q from its centre.
inline constexpr double kBall = 3.0, kBallMoment = 0.1, kBead = 1.5;

inline model::KinematicTree ball_and_bead() {
  model::Description d;
  d.name = "ball_and_bead";
  d.floating_base = true;
  d.base = model::test::link("ball", {{"bead", "wire", {}, {}}});
  d.base.inertia = model::test::ball(kBall, kBallMoment);
  d.links = {model::test::link("bead")};
  d.links[0].inertia = model::test::ball(kBead, 0);
  model::Placement along_x;
  along_x.rotation[1] = model::test::pi(1, 2);
  d.joints = {model::test::joint("wire", model::JointType::prismatic, along_x)};
  return built(d);
}

inline std::vector<double> run(const symbolic::Program& program, const symbolic::Arrays<double>& inputs) {
  EXPECT_EQ(verify(program), "");
  return symbolic::interpret<double>(program, inputs).at(program.outputs.at(0).name);
}

inline void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], kByHand) << "element " << k;
}

}  // namespace robcogen::algorithm::test
