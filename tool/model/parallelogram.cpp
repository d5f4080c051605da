#include "model/parallelogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "model/loop_geometry.h"
#include "model/loop_plane.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

// As a fraction of the size of a loop.
constexpr double kEqual = 1e-12;
// The sine of the angle between two sides below which a parallelogram is flat.
constexpr double kFlat = 1e-6;

struct Point {
  double x = 0.0, y = 0.0;
};

Point step(const Point& from, const Point& to) {
  return {to.x - from.x, to.y - from.y};
}
double length(const Point& a) {
  return std::hypot(a.x, a.y);
}

// A joint of the closed chain of links; -1 for the joint that closes the loop.
struct Pivot {
  int joint = -1;
  int sense = 0;  // sense of rotation of the next link relative to the one before
  Point point;
};

// Joints that share one axis.
using Corner = std::vector<Pivot>;

// The pivots in order, outwards along the first end and back along the second.
std::vector<Pivot> ring(const Closure& closure, const LoopPosture& posture) {
  const auto in_plane = [&](const Numbers3& p) { return Point{dot(closure.plane[0], p), dot(closure.plane[1], p)}; };
  std::array<std::vector<Pivot>, 2> ends;
  for (const LoopScrew& screw : posture.screws) {
    const auto e = static_cast<std::size_t>(screw.end);
    const int sense = closure.senses[e][ends[e].size()];
    ends[e].push_back({screw.joint, e == 0 ? sense : -sense, in_plane(screw.origin)});
  }
  std::vector<Pivot> result = ends[0];
  result.push_back({-1, 0, in_plane(posture.points[0])});
  result.insert(result.end(), ends[1].rbegin(), ends[1].rend());
  return result;
}

std::vector<Corner> corners(const std::vector<Pivot>& pivots, double tolerance) {
  std::vector<Corner> result;
  for (const Pivot& pivot : pivots) {
    const bool is_new = result.empty() || length(step(result.back().back().point, pivot.point)) > tolerance;
    if (is_new) result.emplace_back();
    result.back().push_back(pivot);
  }
  if (result.size() > 1 && length(step(result.back().back().point, result.front().front().point)) <= tolerance) {
    result.front().insert(result.front().begin(), result.back().begin(), result.back().end());
    result.pop_back();
  }
  return result;
}

// Returns the four corners, or none if the links do not form a parallelogram.
std::vector<Corner> parallelogram(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& parameters,
    const Closure& closure) {
  const LoopPosture drawn = posture(tree, loop, std::vector<double>(tree.joints.size()), parameters);
  const double tolerance = kEqual * size_of(drawn);
  const Numbers3 gap = drawn.points[0] - drawn.points[1];
  if (std::hypot(dot(closure.plane[0], gap), dot(closure.plane[1], gap)) > tolerance) return {};
  const std::vector<Pivot> pivots = ring(closure, drawn);
  const bool slides = std::any_of(
      pivots.begin(), pivots.end(), [](const Pivot& pivot) { return pivot.joint >= 0 && pivot.sense == 0; });
  if (slides) return {};
  const std::vector<Corner> found = corners(pivots, tolerance);
  if (found.size() != 4) return {};
  const Point side = step(found[0][0].point, found[1][0].point), opposite = step(found[3][0].point, found[2][0].point);
  return length(step(side, opposite)) <= tolerance ? found : std::vector<Corner>();
}

bool closes_the_loop(const Corner& corner) {
  return std::any_of(corner.begin(), corner.end(), [](const Pivot& pivot) { return pivot.joint < 0; });
}

}  // namespace

bool Parallelogram::determines(const std::vector<int>& joints) const {
  const auto first = sums_.find(joints.front()), second = sums_.find(joints.back());
  if (joints.size() != 2 || first == sums_.end() || second == sums_.end()) return false;
  return first->second[0] * second->second[1] != first->second[1] * second->second[0];
}

bool Parallelogram::holds(const std::vector<double>& q) const {
  constexpr double kSameAngle = 1e-6;  // rad
  for (const std::size_t sum : {std::size_t{0}, std::size_t{1}}) {
    double total = 0.0;
    for (const auto& [joint, counts] : sums_) total += counts[sum] * q[at(joint)];
    if (!(std::abs(std::remainder(total, 2.0 * std::acos(-1.0))) < kSameAngle)) return false;
  }
  return true;
}

std::vector<std::vector<LoopShare>> Parallelogram::shares(const std::vector<int>& dependents) const {
  const std::array<int, 2>&a = sums_.at(dependents[0]), &b = sums_.at(dependents[1]);
  const int determinant = a[0] * b[1] - a[1] * b[0];
  std::vector<std::vector<LoopShare>> result(2);
  for (const auto& [joint, counts] : sums_) {
    if (joint == dependents[0] || joint == dependents[1]) continue;
    const int first = (counts[1] * b[0] - counts[0] * b[1]) / determinant;
    const int second = (counts[0] * a[1] - counts[1] * a[0]) / determinant;
    if (first != 0) result[0].push_back({joint, static_cast<double>(first)});
    if (second != 0) result[1].push_back({joint, static_cast<double>(second)});
  }
  return result;
}

std::optional<Parallelogram> find_parallelogram(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& parameters,
    const Closure& closure) {
  // Assembled on the other branch, its links cross.
  if (closure.method != Closure::Method::planar || loop.takes_other_branch) return std::nullopt;
  const std::vector<Corner> found = parallelogram(tree, loop, parameters, closure);
  if (found.empty()) return std::nullopt;
  for (const double change : {0.05, -0.03}) {
    std::vector<double> others = parameters;
    for (std::size_t k = 0; k < others.size(); ++k) others[k] += change * (1.0 + 0.2 * static_cast<double>(k));
    if (parallelogram(tree, loop, others, closure).empty()) return std::nullopt;
  }
  // Opposite corners turn by the same angle, and adjacent corners by opposite angles. The joint that closes the loop
  // has no position; the other three corners give two sums: the two neighbours of that joint against one another, and
  // one neighbour against the third corner.
  std::size_t k = 0;
  while (!closes_the_loop(found[k])) ++k;
  Parallelogram::Sums sums;
  const auto add = [&](std::size_t corner, int first, int second) {
    for (const Pivot& pivot : found[corner % 4]) sums[pivot.joint] = {first * pivot.sense, second * pivot.sense};
  };
  add(k + 1, 1, 1);
  add(k + 2, 0, 1);
  add(k + 3, -1, 0);
  const Point side = step(found[0][0].point, found[1][0].point), next = step(found[1][0].point, found[2][0].point);
  const double area = std::abs(side.x * next.y - side.y * next.x);
  return Parallelogram(std::move(sums), area < kFlat * length(side) * length(next));
}

namespace {

// Returns the coupling of a joint as a sum over independent joints; nullopt if a joint that it follows depends
// nonlinearly on the coordinates.
std::optional<Coupling> coupled(
    const KinematicTree& tree,
    const std::set<int>& in_no_proportion,
    int joint,
    const std::vector<LoopShare>& shares) {
  std::map<int, Quantity> factors;
  Coupling result;
  result.joint = joint;
  for (const LoopShare& share : shares) {
    if (in_no_proportion.contains(share.joint)) return std::nullopt;
    const Quantity factor(share.factor);
    const Coupling* given = tree.coupling_of(share.joint);
    if (given == nullptr) {
      factors[share.joint] = factors[share.joint] + factor;
      continue;
    }
    result.offset = result.offset + factor * given->offset;
    for (const Coupling::Term& term : given->terms) factors[term.joint] = factors[term.joint] + factor * term.factor;
  }
  for (const auto& [followed, factor] : factors)
    if (!factor.is_zero()) result.terms.push_back({followed, factor});
  return result;
}

}  // namespace

void couple_parallelograms(KinematicTree& tree) {
  std::vector<Closure> others;
  std::set<int> in_no_proportion;
  for (Closure& closure : tree.closures) {
    std::vector<Coupling> couplings;
    for (std::size_t d = 0; d < closure.shares.size(); ++d)
      if (auto coupling = coupled(tree, in_no_proportion, closure.dependents[d], closure.shares[d]))
        couplings.push_back(*std::move(coupling));
    if (couplings.empty() || couplings.size() < closure.dependents.size()) {
      in_no_proportion.insert(closure.dependents.begin(), closure.dependents.end());
      closure.shares.clear();
      others.push_back(std::move(closure));
      continue;
    }
    for (Coupling& coupling : couplings) {
      coupling.loop = closure.loop();
      const auto place = std::lower_bound(
          tree.couplings.begin(), tree.couplings.end(), coupling.joint,
          [](const Coupling& c, int joint) { return c.joint < joint; });
      tree.couplings.insert(place, std::move(coupling));
    }
    tree.parallelograms.push_back(std::move(closure));
  }
  tree.closures = std::move(others);
}

}  // namespace robcogen::model
