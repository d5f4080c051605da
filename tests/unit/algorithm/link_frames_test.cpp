// Link frames: placements split along axes, and the results of the search. That results do not depend on frames is a
// property of random robots (tests/numeric/passes_test.cpp).
#include "algorithm/formulation/link_frames.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "algorithm/dynamics/dynamics.h"
#include "algorithm/search/frame_search.h"
#include "hand_robots.h"
#include "symbolic/count.h"

namespace robcogen::algorithm {
namespace {

using namespace test;

constexpr double kTolerance = 1e-13;  // some roundings of numbers of size 1, divided by sines of no less than 0.1

double value(const model::Quantity& q) {
  return q.number().value();
}

Eigen::Isometry3d matrix_of(const std::vector<model::PrimitiveTransform>& primitives) {
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  for (const model::PrimitiveTransform& p : primitives) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<int>(p.axis));
    if (p.rotation)
      t = t * Eigen::AngleAxisd(value(p.amount), axis);
    else
      t = t * Eigen::Translation3d(value(p.amount) * axis);
  }
  return t;
}

Eigen::Isometry3d matrix_of(const model::Placement& placement) {
  std::vector<model::PrimitiveTransform> primitives;
  for (const bool rotation : {false, true})
    for (const model::Axis axis : {model::Axis::x, model::Axis::y, model::Axis::z})
      primitives.push_back(
          {rotation, axis, (rotation ? placement.rotation : placement.translation)[static_cast<std::size_t>(axis)]});
  return matrix_of(primitives);
}

void expect_split_is_whole(const model::Placement& placement) {
  const AxisPlacement split = axis_placement(placement);
  const Eigen::Isometry3d there = matrix_of(split.to_axis) * Eigen::Translation3d(0, 0, value(split.along));
  EXPECT_TRUE(there.isApprox(matrix_of(placement), kTolerance)) << there.matrix() << "\n\n"
                                                                << matrix_of(placement).matrix();
}

TEST(AxisPlacement, IsThePlacement) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 500; ++i) {
    model::Placement placement;
    for (std::size_t k = 0; k < 3; ++k) {
      placement.translation[k] = model::Quantity(uniform(random));
      placement.rotation[k] = i % 3 == 0
                                  ? model::Quantity(Number::pi_multiple(static_cast<int>(3 * uniform(random)), 2))
                                  : model::Quantity(3 * uniform(random));
    }
    if (i % 3 == 1) placement.rotation[0] = placement.rotation[1] = model::Quantity();  // parallel axes
    const Eigen::Matrix3d r = matrix_of(placement).linear();
    const double sine = std::hypot(r(0, 2), r(1, 2));
    if (sine > 1e-12 && sine < 0.1) continue;
    expect_split_is_whole(placement);
  }
}

// An elbow at a right angle: turns about its axis commute with its motion.
TEST(AxisPlacement, SplitsAtRightAnglesExactly) {
  model::Placement placement;
  placement.translation = {
      model::Quantity(*Number::parse("0.3")), model::Quantity(*Number::parse("0.4")),
      model::Quantity(*Number::parse("0.5"))};
  placement.rotation[0] = model::test::pi(1, 2);  // z becomes -y
  const AxisPlacement split = axis_placement(placement);
  EXPECT_EQ(value(split.along), -0.4);
  ASSERT_EQ(split.to_axis.size(), 3U);
  EXPECT_EQ(value(split.to_axis[0].amount), 0.3);
  EXPECT_EQ(value(split.to_axis[1].amount), 0.5);
}

symbolic::Program inertia(const model::KinematicTree& tree, const Formulation& formulation) {
  return joint_space_inertia(tree, "H", formulation);
}

// The second rod of a planar arm, given in axes that its mass is not on.
model::KinematicTree crooked_arm() {
  model::Description d;
  d.name = "crooked";
  d.base = model::test::link("base", {{"upper", "shoulder", {}, {}}});
  d.links = {model::test::link("upper", {{"lower", "elbow", {}, {}}}), model::test::link("lower")};
  d.links[0].inertia = point_mass_on_x(1.0, 0.5);
  d.links[1].inertia = point_mass_on_x(1.0, 0.5);
  d.links[1].inertia->com[1] = model::Quantity(0.25);
  d.links[1].inertia->ixy = model::Quantity(0.5 * 0.25);
  d.links[1].inertia->ixx = model::Quantity(0.25 * 0.25);
  d.links[1].inertia->izz = model::Quantity(0.25 + 0.25 * 0.25);
  model::Placement elbow;
  elbow.translation[0] = model::Quantity(1.0);
  d.joints = {
      model::test::joint("shoulder", model::JointType::revolute, {}),
      model::test::joint("elbow", model::JointType::revolute, elbow)};
  return built(d);
}

TEST(FrameSearch, PutsTheAxisThroughTheMass) {
  const model::KinematicTree tree = crooked_arm();
  const LinkFrames frames = cheap_frames(tree, {.effort = 1}, inertia);
  ASSERT_EQ(frames.size(), 2U);
  const double turn = value(frames[1].turn);
  EXPECT_NEAR(std::remainder(turn - std::atan2(0.25, 0.5), std::numbers::pi / 2), 0.0, 1e-12) << turn;
  EXPECT_LT(symbolic::work(inertia(tree, {.frames = frames})), symbolic::work(inertia(tree, {})));
}

TEST(FrameSearch, FindsTheSameAgain) {
  const model::KinematicTree tree = crooked_arm();
  const auto text = [&] { return description(tree, cheap_frames(tree, {.effort = 1}, inertia)); };
  EXPECT_EQ(text(), text());
  EXPECT_NE(text(), "");
}

TEST(FrameSearch, LeavesFramesWithoutEffort) {
  const model::KinematicTree tree = crooked_arm();
  EXPECT_TRUE(cheap_frames(tree, {}, inertia).empty());
  EXPECT_TRUE(cheap_frames(tree, {.choose_frames = false, .turn_inertia = false, .effort = 1}, inertia).empty());
  for (const LinkFrame& frame : cheap_frames(tree, {.choose_frames = false, .effort = 1}, inertia))
    EXPECT_TRUE(frame.turn.is_zero() && frame.slide.is_zero());
  for (const LinkFrame& frame : cheap_frames(tree, {.turn_inertia = false, .effort = 1}, inertia))
    EXPECT_TRUE(frame.turns_with_joint);
}

}  // namespace
}  // namespace robcogen::algorithm
