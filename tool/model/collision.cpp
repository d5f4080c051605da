#include "model/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

#include "support/index.h"

namespace robcogen::model {
namespace {

using Point3 = std::array<double, 3>;

// In the frame of the shape.
struct Segment {
  std::array<Point3, 2> ends = {};
  double radius = 0;
};

Segment along_z(double radius, double length) {
  return {{{{0, 0, -length / 2}, {0, 0, length / 2}}}, radius};
}

double length_of(const Segment& s) {
  return std::hypot(s.ends[1][0] - s.ends[0][0], s.ends[1][1] - s.ends[0][1], s.ends[1][2] - s.ends[0][2]);
}

double volume(const Segment& s) {
  return std::numbers::pi * s.radius * s.radius * (length_of(s) + 4.0 / 3.0 * s.radius);
}

// Around points, along this coordinate axis. Its axis is in the middle of the points; the half spheres at its ends
// reach over the points beyond the segment.
Segment around(const std::vector<Point3>& points, std::size_t axis) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point3 low, high;
  low.fill(kInfinity), high.fill(-kInfinity);
  for (const Point3& p : points)
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  Point3 middle;
  for (std::size_t k = 0; k < 3; ++k) middle[k] = low[k] + (high[k] - low[k]) / 2;
  const auto from_axis = [&](const Point3& p) { return std::hypot(p[u] - middle[u], p[v] - middle[v]); };
  double radius = 0;
  for (const Point3& p : points) radius = std::max(radius, from_axis(p));
  double first = kInfinity, last = -kInfinity;
  for (const Point3& p : points) {
    const double distance = from_axis(p), reach = std::sqrt(std::max(0.0, radius * radius - distance * distance));
    first = std::min(first, p[axis] + reach);
    last = std::max(last, p[axis] - reach);
  }
  if (first > last) first = last = last + (first - last) / 2;  // a sphere is enough
  Segment result{{middle, middle}, radius};
  result.ends[0][axis] = first;
  result.ends[1][axis] = last;
  return result;
}

Segment smallest_around(const std::vector<Point3>& points) {
  Segment best = around(points, 0);
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}}) {
    Segment other = around(points, axis);
    if (volume(other) < volume(best)) best = std::move(other);
  }
  return best;
}

std::vector<Point3> corners_of(const std::array<double, 3>& edges) {
  std::vector<Point3> corners(8);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t k = 0; k < 3; ++k) corners[i][k] = ((i >> k) & 1 ? 0.5 : -0.5) * edges[k];
  return corners;
}

std::vector<Point3> vertices_of(const Shape& shape) {
  std::vector<Point3> vertices;
  for (const auto& v : shape.mesh->vertices)
    vertices.push_back({shape.size[0] * v[0], shape.size[1] * v[1], shape.size[2] * v[2]});
  return vertices;
}

Segment segment_of(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return along_z(shape.size[0], 0);
    case Shape::Kind::capsule:
    case Shape::Kind::cylinder:
      return along_z(shape.size[0], shape.size[1]);
    case Shape::Kind::box:
      return smallest_around(corners_of(shape.size));
    case Shape::Kind::mesh:
      break;
  }
  return smallest_around(vertices_of(shape));
}

Segment without_short_axis(Segment s) {
  constexpr double kShortest = 1e-6;  // m
  const double length = length_of(s);
  if (length == 0 || length >= kShortest) return s;
  for (std::size_t k = 0; k < 3; ++k) s.ends[0][k] = s.ends[1][k] = s.ends[0][k] + (s.ends[1][k] - s.ends[0][k]) / 2;
  s.radius += length / 2;
  return s;
}

Point3 in_link(const Placement& placement, const Point3& p) {
  const auto R = rotation_matrix(placement);
  Point3 result;
  for (std::size_t r = 0; r < 3; ++r) {
    result[r] = evaluate(placement.translation[r]);
    for (std::size_t c = 0; c < 3; ++c)
      if (p[c] != 0) result[r] += evaluate(R[r][c]) * p[c];
  }
  return result;
}

// The body that carries the link: past those that are none, which are between the joints of a body or the components of
// a joint. -1 for the base.
int parent_of(const KinematicTree& tree, int link) {
  const auto next = [&](int l) {
    const int joint = tree.links[at(l)].parent_joint;
    return joint < 0 ? -1 : tree.joints[at(joint)].parent;
  };
  int parent = next(link);
  while (parent >= 0 && (tree.links[at(parent)].is_virtual || tree.links[at(parent)].is_repeated))
    parent = next(parent);
  return parent;
}

// Pairs of links, in both orders, that a joint connects, or one that closes a loop.
std::set<std::array<int, 2>> neighbours(const KinematicTree& tree) {
  std::set<std::array<int, 2>> pairs;
  const auto add = [&](int a, int b) { pairs.insert({{a, b}, {b, a}}); };
  for (int link = 0; link < static_cast<int>(tree.links.size()); ++link)
    if (const int parent = parent_of(tree, link); parent >= 0) add(link, parent);
  for (const LoopJoint& loop : tree.loops)
    if (loop.type != LoopType::distance) add(loop.ends[0].link, loop.ends[1].link);
  return pairs;
}

// Pairs of bodies, in both orders, that are not checked.
std::set<std::array<std::string_view, 2>> unchecked_bodies(const Geometry& geometry) {
  std::set<std::array<std::string_view, 2>> pairs;
  for (const auto& [a, b] : geometry.may_touch) pairs.insert({{a, b}, {b, a}});
  return pairs;
}

}  // namespace

std::vector<Capsule> capsules(const KinematicTree& tree) {
  std::vector<Capsule> result;
  std::map<std::string, int> counts;
  for (const Shape& shape : tree.geometry.shapes)
    if (shape.use == Shape::Use::collision) ++counts[shape.body];
  std::map<std::string, int> numbers;
  for (const Shape& shape : tree.geometry.shapes) {
    if (shape.use != Shape::Use::collision) continue;
    const Segment segment = without_short_axis(segment_of(shape));
    Capsule capsule{shape.body, shape.body, shape.link, {}, segment.radius};
    const bool is_numbered = counts[shape.body] > 1;
    while (is_numbered && counts.contains(capsule.name))  // the name of this body, or of another one
      capsule.name = shape.body + "_" + std::to_string(++numbers[shape.body]);
    for (std::size_t k = 0; k < 2; ++k) capsule.ends[k] = in_link(shape.placement, segment.ends[k]);
    result.push_back(std::move(capsule));
  }
  return result;
}

std::vector<std::array<std::size_t, 2>> collision_pairs(
    const KinematicTree& tree,
    const std::vector<Capsule>& capsules) {
  std::vector<std::array<std::size_t, 2>> pairs;
  const std::set<std::array<int, 2>> near = tree.geometry.has_srdf ? std::set<std::array<int, 2>>() : neighbours(tree);
  const std::set<std::array<std::string_view, 2>> unchecked = unchecked_bodies(tree.geometry);
  for (std::size_t i = 0; i < capsules.size(); ++i)
    for (std::size_t k = i + 1; k < capsules.size(); ++k) {
      const Capsule &a = capsules[i], &b = capsules[k];
      if (a.link == b.link || near.contains({a.link, b.link})) continue;
      if (!unchecked.contains({a.body, b.body})) pairs.push_back({i, k});
    }
  return pairs;
}

}  // namespace robcogen::model
