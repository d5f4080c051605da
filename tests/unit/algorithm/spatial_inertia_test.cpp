// Spatial inertias in three blocks, compared with Eigen's 6 x 6 matrices.
#include "algorithm/spatial/spatial_inertia.h"

#include <set>
#include <string>
#include <vector>

#include "algorithm/spatial/named.h"
#include "bodies.h"
#include "symbolic/text.h"

namespace robcogen::algorithm::spatial_inertia_test {
namespace {

using test::Cloud;
using test::kTolerance;
using test::Matrix6d;
using test::Numbers;
using test::RandomPose;

constexpr double kMoved = 10 * kTolerance;  // two products of 6 x 6 matrices

class SpatialInertias : public testing::TestWithParam<int> {
 protected:
  Numbers n{static_cast<unsigned>(GetParam())};
};

// Any symmetric matrix, because the three blocks of an articulated body's inertia have no zeros.
SpatialInertia random_inertia(Numbers& n) {
  return {n.symmetric(), n.matrix(), n.symmetric()};
}

TEST_P(SpatialInertias, OfARigidBodyIsTheSumOverItsPoints) {
  const Cloud body = Cloud::random(n);
  EXPECT_TRUE(value(n, rigid_body_inertia(body.symbols(n))).isApprox(body.spatial_inertia(), kTolerance));
}

TEST_P(SpatialInertias, MatrixHoldsTheBlocks) {
  const SpatialInertia x = random_inertia(n);
  const Matrix6d m = value(n, x);
  EXPECT_TRUE(m.isApprox(m.transpose(), 0));
  EXPECT_EQ((m.topLeftCorner<3, 3>()), n.value(x.a));
  EXPECT_EQ((m.topRightCorner<3, 3>()), n.value(x.b));
  EXPECT_EQ((m.bottomRightCorner<3, 3>()), n.value(x.m));
}

TEST_P(SpatialInertias, AddUp) {
  const SpatialInertia x = random_inertia(n), y = random_inertia(n);
  EXPECT_TRUE(value(n, x + y).isApprox(value(n, x) + value(n, y), kTolerance));
}

// I_P = X* I_C X*', where X* transforms forces (Featherstone 2008, eq. 2.66).
TEST_P(SpatialInertias, MoveToTheParent) {
  const RandomPose random(n);
  const SpatialInertia child = random_inertia(n);
  const Matrix6d x = test::force_transform(random.transform);
  const Matrix6d expected = x * value(n, child) * x.transpose();
  EXPECT_TRUE(value(n, to_parent(random.pose, child)).isApprox(expected, kMoved));
}

// The inertia moves with the body.
TEST_P(SpatialInertias, OfAMovedBodyAreThoseOfItsMovedPoints) {
  const RandomPose random(n);
  const Cloud body = Cloud::random(n);
  Cloud moved = body;
  for (Eigen::Vector3d& point : moved.at) point = random.transform * point;
  const SpatialInertia x = to_parent(random.pose, rigid_body_inertia(body.symbols(n)));
  EXPECT_TRUE(value(n, x).isApprox(moved.spatial_inertia(), kMoved));
}

INSTANTIATE_TEST_SUITE_P(, SpatialInertias, testing::Range(0, 30));

TEST(SpatialInertiaNames, AreThoseOfTheElements) {
  Numbers n;
  const SpatialInertia x = named("foot", random_inertia(n) + random_inertia(n));
  std::vector<Expression> elements = matrix(x).columns();
  const symbolic::Program p = test::program(n.graph, n.inputs.size(), elements);
  const std::vector<std::string> list = statement_names(p);
  const std::set<std::string> names(list.begin(), list.end());
  EXPECT_EQ(names.size(), 6U + 9U + 6U);
  for (const char* expected : {"foot_Axx", "foot_Ayz", "foot_Bxz", "foot_Bzx", "foot_Mxy", "foot_Mzz"})
    EXPECT_TRUE(names.contains(expected)) << expected;
  EXPECT_FALSE(names.contains("foot_Azy"));
  // The name gives the position in B; below the diagonal is B'.
  const symbolic::Operand& below = p.outputs[0].values[5];  // row 5, column 0
  EXPECT_EQ(list[static_cast<std::size_t>(below.index)], "foot_Bxz");
}

}  // namespace
}  // namespace robcogen::algorithm::spatial_inertia_test
