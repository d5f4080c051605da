#include "view/simplify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace robcogen::view {
namespace {

using model::TriangleMesh;
using Vertex = std::array<float, 3>;

struct Bounds {
  Vertex low{}, high{};
  float largest = 0;  // edge
};

Bounds bounds_of(const TriangleMesh& mesh) {
  Bounds bounds{mesh.vertices.front(), mesh.vertices.front(), 0};
  for (const Vertex& v : mesh.vertices)
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.low[k] = std::min(bounds.low[k], v[k]);
      bounds.high[k] = std::max(bounds.high[k], v[k]);
    }
  for (std::size_t k = 0; k < 3; ++k) bounds.largest = std::max(bounds.largest, bounds.high[k] - bounds.low[k]);
  return bounds;
}

// With this number of cells along the largest edge.
TriangleMesh clustered(const TriangleMesh& mesh, const Bounds& bounds, int cells) {
  const float step = bounds.largest / static_cast<float>(cells);
  const auto row = static_cast<std::uint64_t>(cells) + 1;
  std::map<std::uint64_t, std::uint32_t> clusters;
  std::vector<std::uint32_t> cluster_of;
  std::vector<std::array<double, 4>> sums;  // of vertices, and their number
  cluster_of.reserve(mesh.vertices.size());
  for (const Vertex& v : mesh.vertices) {
    std::uint64_t cell = 0;
    for (std::size_t k = 0; k < 3; ++k) cell = cell * row + static_cast<std::uint64_t>((v[k] - bounds.low[k]) / step);
    const auto [at, is_new] = clusters.insert({cell, static_cast<std::uint32_t>(sums.size())});
    if (is_new) sums.emplace_back();
    std::array<double, 4>& sum = sums[at->second];
    for (std::size_t k = 0; k < 3; ++k) sum[k] += v[k];
    sum[3] += 1;
    cluster_of.push_back(at->second);
  }
  TriangleMesh result;
  for (const std::array<double, 4>& sum : sums)
    result.vertices.push_back(
        {static_cast<float>(sum[0] / sum[3]), static_cast<float>(sum[1] / sum[3]),
         static_cast<float>(sum[2] / sum[3])});
  std::set<std::array<std::uint32_t, 3>> known;
  for (const auto& face : mesh.faces) {
    std::array<std::uint32_t, 3> f = {cluster_of[face[0]], cluster_of[face[1]], cluster_of[face[2]]};
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0]) continue;
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    if (known.insert(f).second) result.faces.push_back(f);
  }
  return result;
}

}  // namespace

TriangleMesh simplified(const TriangleMesh& mesh, std::size_t limit) {
  if (mesh.faces.size() <= limit || mesh.vertices.empty()) return mesh;
  const Bounds bounds = bounds_of(mesh);
  if (!(bounds.largest > 0)) return mesh;
  // The number of triangles grows with the square of the number of cells along an edge.
  int cells = std::max(2, static_cast<int>(std::sqrt(static_cast<double>(limit))));
  constexpr int kTries = 12;
  TriangleMesh result;
  for (int k = 0; k < kTries; ++k) {
    TriangleMesh next = clustered(mesh, bounds, cells);
    if (next.faces.empty()) break;
    const double ratio = static_cast<double>(limit) / static_cast<double>(next.faces.size());
    const bool is_short = ratio >= 1;
    if (is_short && next.faces.size() > result.faces.size()) result = std::move(next);
    if (is_short && ratio < 1.25) break;
    const int better = static_cast<int>(cells * std::sqrt(ratio) * (is_short ? 0.97 : 0.95));
    if (better == cells || better < 1) break;
    cells = better;
  }
  if (!result.faces.empty()) return result;
  result = mesh;
  result.faces.resize(std::max<std::size_t>(1, limit));
  return result;
}

}  // namespace robcogen::view
