// Pivots of inertia matrices, compared with matrices from Jacobians.
#include "model/inertia_pivots.h"

#include <gtest/gtest.h>

#include <numeric>

#include "inertia_reference.h"
#include "linear_algebra.h"

namespace robcogen::model::inertia_pivots_test {
namespace {

using test::number;

constexpr double kRounding = 1e-11;

// Bodies with skew axes; the second joint has this type.
Description two_bodies(JointType type, bool is_floating) {
  Description d = test::two_links();
  d.floating_base = is_floating;
  d.joints[1].type = type;
  for (std::size_t i = 0; i < 3; ++i) {
    d.joints[1].placement.translation[i] = number(0.5 - 0.25 * static_cast<double>(i));
    d.joints[1].placement.rotation[i] = number(0.3 + 0.2 * static_cast<double>(i));
  }
  d.base.inertia = test::ball(3.0, 0.5);
  d.links[0].inertia = test::ball(2.0, 0.25);
  d.links[1].inertia = test::ball(1.0, 0.125);
  return d;
}

KinematicTree built(const Description& d) {
  Diagnostics diagnostics;
  const std::optional<KinematicTree> tree = build(d, diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  return *tree;
}

// Returns the inertia matrix at the position to which the pivots belong.
Eigen::MatrixXd inertia(const Description& d) {
  const std::vector<double> q = OrdinaryNumbers().next(d.joints.size());
  return test::inertia_matrix(d, {0, 1}, Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<int>(q.size())));
}

double product(const Pivots& pivots) {
  double result = 1.0;
  for (const std::vector<double>* list : {&pivots.joints, &pivots.base})
    for (const double pivot : *list) result *= pivot;
  return result;
}

TEST(InertiaPivots, MultiplyToTheDeterminant) {
  for (const JointType type : {JointType::revolute, JointType::prismatic}) {
    for (const bool is_floating : {false, true}) {
      const Description d = two_bodies(type, is_floating);
      const double determinant = robcogen::test::determinant(inertia(d));
      EXPECT_NEAR(product(pivots_of(built(d), Beyond::free, 0.0)) / determinant, 1.0, kRounding);
      EXPECT_NEAR(product(pivots_of_coordinates(built(d), Beyond::free, 0.0)) / determinant, 1.0, kRounding);
    }
  }
}

TEST(InertiaPivots, BeforeLockedJointsAreTheDiagonal) {
  for (const JointType type : {JointType::revolute, JointType::prismatic}) {
    const Description d = two_bodies(type, false);
    const Eigen::MatrixXd H = inertia(d);
    for (const auto& pivots_in : {pivots_of, pivots_of_coordinates}) {
      const std::vector<double> found = pivots_in(built(d), Beyond::locked, 0.0).joints;
      ASSERT_EQ(found.size(), 2U);
      for (int j = 0; j < 2; ++j) EXPECT_NEAR(found[static_cast<std::size_t>(j)] / H(j, j), 1.0, kRounding);
    }
  }
}

TEST(InertiaPivots, AdditionsAreInProportion) {
  const KinematicTree tree = built(two_bodies(JointType::revolute, false));
  const double without = pivots_of(tree, Beyond::free, 0.0).joints[1];
  const double once = pivots_of(tree, Beyond::free, 0.125).joints[1],
               twice = pivots_of(tree, Beyond::free, 0.25).joints[1];
  EXPECT_GT(once, without);
  EXPECT_NEAR(twice - once, once - without, kRounding * twice);
}

}  // namespace
}  // namespace robcogen::model::inertia_pivots_test
