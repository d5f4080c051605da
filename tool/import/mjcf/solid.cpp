#include "import/mjcf/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/magnitudes.h"

namespace robcogen::import::from_mjcf {

namespace {

constexpr double kLeast = 1e-15;  // of volumes and areas, in MuJoCo

struct Triangle {
  std::array<Vector3, 3> corners;

  Vector3 center() const {
    Vector3 sum = {};
    for (const Vector3& corner : corners)
      for (std::size_t i = 0; i < 3; ++i) sum[i] += corner[i] / 3.0;
    return sum;
  }
  // Twice the area, along the normal.
  Vector3 normal() const { return cross(corners[1] - corners[0], corners[2] - corners[0]); }
  double area() const { return std::sqrt(dot(normal(), normal())) / 2.0; }
};

bool passes_an_edge_twice(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i)
      if (face[i] != face[(i + 1) % 3]) edges.emplace_back(face[i], face[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

std::vector<Vector3> transformed_vertices(const TriangleMesh& mesh, const MeshTransform& transform) {
  std::vector<Vector3> vertices;
  for (const auto& v : mesh.vertices) {
    const Vector3 from = Vector3{v[0], v[1], v[2]} - transform.shift;
    Vector3 to = {};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) to[i] += transform.turn[k][i] * from[k];
      to[i] *= transform.scale[i];
    }
    vertices.push_back(to);
  }
  return vertices;
}

// A mirrored mesh has its outside inside: the order of the vertices of its faces is the other one.
std::array<std::uint32_t, 3> turned_outwards(const std::array<std::uint32_t, 3>& face, const MeshTransform& transform) {
  const bool is_mirrored = transform.scale[0] * transform.scale[1] * transform.scale[2] < 0.0;
  return is_mirrored ? std::array{face[0], face[2], face[1]} : face;
}

std::vector<Triangle> transformed(const TriangleMesh& mesh, const MeshTransform& transform) {
  const std::vector<Vector3> vertices = transformed_vertices(mesh, transform);
  std::vector<Triangle> result;
  for (const auto& face : mesh.faces) {
    const auto [a, b, c] = turned_outwards(face, transform);
    result.push_back({{vertices[a], vertices[b], vertices[c]}});
  }
  return result;
}

// The volume of the tetrahedron between the triangle and the point, or the area of the triangle.
double weight(const Triangle& triangle, const Vector3& point, MeshInertia kind) {
  if (kind == MeshInertia::shell) return triangle.area();
  const double volume = dot(triangle.center() - point, triangle.normal()) / 6.0;
  return kind == MeshInertia::legacy ? std::abs(volume) : volume;
}

Vector3 centroid(const std::vector<Triangle>& triangles) {
  double area = 0.0;
  Vector3 sum = {};
  for (const Triangle& t : triangles) {
    area += t.area();
    for (std::size_t i = 0; i < 3; ++i) sum[i] += t.area() * t.center()[i];
  }
  if (area >= kLeast)
    for (double& x : sum) x /= area;
  return sum;
}

// The integral of a product of two coordinates over the tetrahedron between the triangle and the origin, for unit
// volume, or over the triangle, for unit area.
double mean_product(const Triangle& t, std::size_t i, std::size_t k, MeshInertia kind) {
  double of_corners = 0.0, sum_i = 0.0, sum_k = 0.0;
  for (const Vector3& corner : t.corners) {
    of_corners += corner[i] * corner[k];
    sum_i += corner[i], sum_k += corner[k];
  }
  return (of_corners + sum_i * sum_k) / (kind == MeshInertia::shell ? 12.0 : 20.0);
}

}  // namespace

TriangleMesh transformed_mesh(const TriangleMesh& mesh, const MeshTransform& transform) {
  TriangleMesh result;
  for (const Vector3& v : transformed_vertices(mesh, transform))
    result.vertices.push_back({static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])});
  for (const auto& face : mesh.faces) result.faces.push_back(turned_outwards(face, transform));
  return result;
}

std::optional<Solid> solid_of(
    const TriangleMesh& mesh,
    const MeshTransform& transform,
    MeshInertia kind,
    std::string& fault) {
  if (kind == MeshInertia::exact && passes_an_edge_twice(mesh))
    return fault = "its triangles do not have one orientation", std::nullopt;
  const std::vector<Triangle> triangles = transformed(mesh, transform);
  const Vector3 middle = centroid(triangles);
  Solid solid;
  double volume = 0.0;
  // MuJoCo places the mass of a triangle of a shell like that of a tetrahedron.
  for (const Triangle& t : triangles) {
    const double part = weight(t, middle, kind);
    volume += part;
    for (std::size_t i = 0; i < 3; ++i) solid.center[i] += part * (0.75 * t.center()[i] + 0.25 * middle[i]);
  }
  if (!(volume >= kLeast)) {
    fault = volume < 0.0 ? "its volume is negative: its triangles face inwards" : "it has no volume";
    return std::nullopt;
  }
  for (double& x : solid.center) x /= volume;

  double xx = 0.0, yy = 0.0, zz = 0.0;
  for (const Triangle& given : triangles) {
    Triangle t = given;
    for (Vector3& corner : t.corners) corner = corner - solid.center;
    const double part = weight(t, Vector3(), kind);
    solid.volume += part;
    xx += part * mean_product(t, 0, 0, kind), yy += part * mean_product(t, 1, 1, kind);
    zz += part * mean_product(t, 2, 2, kind);
    solid.xy -= part * mean_product(t, 0, 1, kind), solid.xz -= part * mean_product(t, 0, 2, kind);
    solid.yz -= part * mean_product(t, 1, 2, kind);
  }
  solid.xx = yy + zz, solid.yy = xx + zz, solid.zz = xx + yy;
  if (std::max(solid.volume, std::max({solid.xx, solid.yy, solid.zz})) >= kTooLarge)
    return fault = "its numbers are too large", std::nullopt;
  return solid;
}

}  // namespace robcogen::import::from_mjcf
