// Spheres around spheres: they contain what they should, and little more.
#include "model/collision_tree.h"

#include <cmath>
#include <set>

#include "chain.h"
#include "files.h"
#include "model/collision.h"
#include "support/index.h"

namespace robcogen::test::tree_test {
namespace {

using model::Ball;

bool contains(const Ball& outer, const Ball& inner) {
  return distance(outer.center, inner.center) + inner.radius <= outer.radius + 1e-12;
}

TEST(CollisionTree, ASphereAroundOthersIsHardlyLargerThanTheSmallest) {
  const std::vector<Ball> pair = {{{0, 0, 0}, 0.5}, {{1, 0, 0}, 0.1}};
  const Ball around_pair = model::around(pair);
  EXPECT_NEAR(around_pair.radius, 0.8, 1e-3);  // from -0.5 to 1.1
  EXPECT_NEAR(around_pair.center[0], 0.3, 1e-3);
  // The corners of a cube, and one sphere inside another one.
  std::vector<Ball> corners;
  for (int k = 0; k < 8; ++k) corners.push_back({{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0}, 0.1});
  EXPECT_NEAR(model::around(corners).radius, std::sqrt(3.0) + 0.1, 5e-3);
  EXPECT_NEAR(model::around({{{0, 0, 0}, 1}, {{0.2, 0, 0}, 0.3}}).radius, 1, 1e-3);
  for (const std::vector<Ball>& balls : {pair, corners})
    for (const Ball& ball : balls) EXPECT_TRUE(contains(model::around(balls), ball));
}

TEST(CollisionTree, GroupsAndPartsContainTheirSpheres) {
  const Loaded robot = loaded(std::filesystem::path(TEST_SOURCE_DIR) / "spheres.urdf", checked());
  const model::CollisionTree tree = model::collision_tree(robot.tree());
  ASSERT_EQ(tree.spheres.size(), 10U);
  ASSERT_EQ(tree.parts.size(), 4U);
  EXPECT_TRUE(tree.is_exact);
  for (const model::CollisionTree::Part& part : tree.parts)
    for (int g = part.first; g < part.first + part.count; ++g) {
      const model::CollisionTree::Group& group = tree.groups[at(g)];
      EXPECT_LE(group.count, 4);
      for (int s = group.first; s < group.first + group.count; ++s) {
        EXPECT_TRUE(contains(group.ball, tree.spheres[at(s)].ball)) << group.name;
        EXPECT_TRUE(contains(part.ball, tree.spheres[at(s)].ball)) << group.name;
      }
    }
}

// The pairs of spheres are those of the shapes, each once.
TEST(CollisionTree, PairsAreThoseOfTheShapes) {
  const Loaded robot = loaded(std::filesystem::path(TEST_SOURCE_DIR) / "spheres.urdf", checked());
  const model::CollisionTree tree = model::collision_tree(robot.tree());
  const std::vector<model::Capsule> shapes = model::capsules(robot.tree());
  std::multiset<std::set<std::string>> expected, found;
  for (const auto& [i, k] : model::collision_pairs(robot.tree(), shapes))
    expected.insert({shapes[i].name, shapes[k].name});
  const auto spheres_of = [&](int place) {
    std::vector<std::string> names;
    const model::CollisionTree::Part& part = tree.parts[at(place)];
    for (int g = part.first; g < part.first + part.count; ++g)
      for (int k = 0; k < tree.groups[at(g)].count; ++k)
        names.push_back(tree.spheres[at(tree.groups[at(g)].first + k)].name);
    return names;
  };
  for (const auto& [a, b] : tree.pairs)
    for (const std::string& first : spheres_of(a))
      for (const std::string& second : spheres_of(b)) found.insert({first, second});
  EXPECT_EQ(found, expected);
}

// Every point of a capsule is in a sphere of its row, and no sphere reaches far beyond.
TEST(CollisionTree, RowsOfSpheresContainCapsules) {
  const Loaded robot = loaded(std::filesystem::path(TEST_SOURCE_DIR) / "chain.urdf", checked());
  const model::CollisionTree tree = model::collision_tree(robot.tree());
  EXPECT_FALSE(tree.is_exact);
  for (const model::Capsule& capsule : model::capsules(robot.tree())) {
    std::vector<Ball> row;
    for (const model::CollisionTree::Sphere& sphere : tree.spheres)
      if (sphere.name == capsule.name) row.push_back(sphere.ball);
    for (const Ball& ball : row) EXPECT_LE(ball.radius, 1.125 * capsule.radius);
    // Points on the surface: beside the axis, and beyond its ends.
    const Point along = {
        capsule.ends[1][0] - capsule.ends[0][0], capsule.ends[1][1] - capsule.ends[0][1],
        capsule.ends[1][2] - capsule.ends[0][2]};
    const double length = std::hypot(along[0], along[1], along[2]);
    const Point axis = length > 0 ? Point{along[0] / length, along[1] / length, along[2] / length} : Point{0, 0, 1};
    const Point side = std::abs(axis[0]) < 0.5 ? Point{0, -axis[2], axis[1]} : Point{-axis[1], axis[0], 0};
    const double norm = std::hypot(side[0], side[1], side[2]);
    for (int k = 0; k <= 100; ++k) {
      const Point p = between(capsule.ends[0], capsule.ends[1], k / 100.0);
      const Point surface = {
          p[0] + capsule.radius * side[0] / norm, p[1] + capsule.radius * side[1] / norm,
          p[2] + capsule.radius * side[2] / norm};
      bool is_inside = false;
      for (const Ball& ball : row) is_inside = is_inside || distance(ball.center, surface) <= ball.radius + 1e-12;
      EXPECT_TRUE(is_inside) << capsule.name << " at " << k;
    }
  }
}

}  // namespace
}  // namespace robcogen::test::tree_test
