// Placements split along axes. Other tests check on random robots that results do not depend on frames
// (frame_search_test.cpp, tests/numeric/passes_test.cpp).
#include "algorithm/formulation/link_frames.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "hand_robots.h"

namespace robcogen::algorithm::link_frames_test {
namespace {

using namespace test;

constexpr double kTolerance = 1e-13;  // a few rounding errors of numbers of size 1, divided by sines of at least 0.1

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

// The cosine of the turn about x between two axes, followed by a turn of 45 degrees.
double cosine_between_axes(const model::Quantity& turn) {
  model::Placement placement;
  placement.translation[0] = model::Quantity(*Number::parse("0.3"));
  placement.rotation[0] = turn;
  placement.rotation[2] = model::test::pi(1, 4);
  expect_split_is_whole(placement);
  double cosine = 1.0;
  for (const model::PrimitiveTransform& p : axis_placement(placement).to_axis)
    if (p.rotation && p.axis == model::Axis::x) cosine = cos(p.amount.number()).value();
  return cosine;
}

// A cosine of 6e-17 instead of zero would cost an operation at each use.
TEST(AxisPlacement, KeepsRightAnglesBesideOthersExact) {
  EXPECT_EQ(cosine_between_axes(model::test::pi(1, 2)), 0.0);
  EXPECT_EQ(cosine_between_axes(model::Quantity(1.5707963267948966)), 0.0);  // as in documents without PI
}

TEST(AxisPlacement, KeepsAnglesThatAreNearlyRight) {
  EXPECT_NEAR(cosine_between_axes(model::Quantity(1.57079632679490)), -3.5e-15, 5e-16);
}

}  // namespace
}  // namespace robcogen::algorithm::link_frames_test
