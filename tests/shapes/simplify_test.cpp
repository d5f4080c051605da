// Meshes with fewer triangles keep their form.
#include "view/simplify.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "files.h"

namespace robcogen::test::simplify_test {
namespace {

using model::TriangleMesh;

// A sphere of radius 1, whose triangles are counter-clockwise from outside.
TriangleMesh sphere(std::uint32_t rows, std::uint32_t around) {
  TriangleMesh mesh;
  for (std::uint32_t r = 0; r <= rows; ++r)
    for (std::uint32_t k = 0; k < around; ++k) {
      const double angle = std::numbers::pi * r / rows, turn = 2 * std::numbers::pi * k / around;
      mesh.vertices.push_back(
          {static_cast<float>(std::sin(angle) * std::cos(turn)), static_cast<float>(std::sin(angle) * std::sin(turn)),
           static_cast<float>(-std::cos(angle))});
    }
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = r * around + k, b = r * around + (k + 1) % around;
      mesh.faces.push_back({a, b, b + around});
      mesh.faces.push_back({a, b + around, a + around});
    }
  return mesh;
}

// The volume inside: six times it is the sum of determinants.
double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const auto &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return sum / 6;
}

TEST(Simplify, KeepsTheFormOfASphere) {
  const TriangleMesh fine = sphere(100, 200);
  ASSERT_EQ(fine.faces.size(), 40000u);
  ASSERT_NEAR(volume(fine), 4.0 / 3.0 * std::numbers::pi, 0.01);
  for (const std::size_t limit : {100u, 1000u, 10000u}) {
    const TriangleMesh mesh = view::simplified(fine, limit);
    EXPECT_LE(mesh.faces.size(), limit);
    EXPECT_GT(mesh.faces.size(), limit / 4);
    EXPECT_NEAR(volume(mesh), 4.0 / 3.0 * std::numbers::pi, 150.0 / static_cast<double>(limit)) << limit;
  }
}

TEST(Simplify, LeavesSmallMeshesAsTheyAre) {
  const TriangleMesh mesh = sphere(4, 8);
  EXPECT_EQ(view::simplified(mesh, 64).faces, mesh.faces);
}

TEST(Simplify, LeavesATriangleOfAnyMesh) {
  TriangleMesh flat;  // all in one cell of any coarse grid, and without extent
  flat.vertices = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  flat.faces.assign(50, {0, 1, 2});
  EXPECT_FALSE(view::simplified(flat, 10).faces.empty());
  TriangleMesh strip;
  for (std::uint32_t k = 0; k < 50; ++k) {
    strip.vertices.push_back({static_cast<float>(k), 0, 0});
    strip.vertices.push_back({static_cast<float>(k), 1e-6F, 0});
    if (k > 0) strip.faces.push_back({2 * k - 2, 2 * k - 1, 2 * k});
  }
  const TriangleMesh few = view::simplified(strip, 10);
  EXPECT_FALSE(few.faces.empty());
  EXPECT_LE(few.faces.size(), 10u);
}

}  // namespace
}  // namespace robcogen::test::simplify_test
