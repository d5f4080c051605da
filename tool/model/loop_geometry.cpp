#include "model/loop_geometry.h"

#include <algorithm>
#include <cmath>

#include "support/index.h"

namespace robcogen::model {
namespace {

struct NumericPose {
  std::array<Numbers3, 3> axes = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};  // columns of the rotation
  Numbers3 origin{};

  Numbers3 turned(const Numbers3& v) const {
    Numbers3 result{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) result[i] += v[k] * axes[k][i];
    return result;
  }
  Numbers3 moved(const Numbers3& point) const { return sum(origin, turned(point)); }

  static Numbers3 sum(const Numbers3& a, const Numbers3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
};

NumericPose behind(const NumericPose& pose, const Placement& placement, const std::vector<double>& parameters) {
  NumericPose result;
  Numbers3 step{};
  for (std::size_t i = 0; i < 3; ++i) step[i] = evaluate(placement.translation[i], parameters);
  result.origin = pose.moved(step);
  const auto rotation = rotation_matrix(placement);
  for (std::size_t column = 0; column < 3; ++column) {
    Numbers3 axis{};
    for (std::size_t row = 0; row < 3; ++row) axis[row] = evaluate(rotation[row][column], parameters);
    result.axes[column] = pose.turned(axis);
  }
  return result;
}

NumericPose behind_joint(
    const NumericPose& placed,
    const Joint& joint,
    double q,
    const std::vector<double>& parameters) {
  NumericPose result = placed;
  const double slide = q * evaluate(slide_of(joint), parameters);
  for (std::size_t i = 0; i < 3; ++i) result.origin[i] += slide * placed.axes[2][i];
  if (!turns(joint.type)) return result;
  const double s = std::sin(q), c = std::cos(q);
  for (std::size_t i = 0; i < 3; ++i) {
    result.axes[0][i] = c * placed.axes[0][i] + s * placed.axes[1][i];
    result.axes[1][i] = c * placed.axes[1][i] - s * placed.axes[0][i];
  }
  return result;
}

bool is_dependent(const Closure& closure, int joint) {
  return std::find(closure.dependents.begin(), closure.dependents.end(), joint) != closure.dependents.end();
}

// The columns of the dependent joints, in their order.
std::vector<std::size_t> dependent_columns(const Closure& closure, const LoopPosture& at) {
  std::vector<std::size_t> places;
  for (const int joint : closure.dependents)
    for (std::size_t k = 0; k < at.screws.size(); ++k)
      if (at.screws[k].joint == joint) places.push_back(k);
  return places;
}

double cross2(const std::vector<double>& a, const std::vector<double>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

// Returns the displacements of the dependent joints that change the rows by `by`.
std::vector<double> solved(
    const Closure& closure,
    const LoopPosture& at,
    const LoopError& e,
    const std::vector<double>& by) {
  const std::vector<std::size_t> d = dependent_columns(closure, at);
  if (d.size() == 1) return {by[0] / e.columns[d[0]][0]};
  const std::vector<double>&first = e.columns[d[0]], &second = e.columns[d[1]];
  const double determinant = cross2(first, second);
  return {cross2(by, second) / determinant, cross2(first, by) / determinant};
}

}  // namespace

Numbers3 cross(const Numbers3& a, const Numbers3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Numbers3& a, const Numbers3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double norm(const Numbers3& a) {
  return std::sqrt(dot(a, a));
}

Numbers3 operator-(const Numbers3& a, const Numbers3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

LoopPosture posture(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& q,
    const std::vector<double>& parameters) {
  LoopPosture result;
  for (std::size_t e = 0; e < 2; ++e) {
    NumericPose pose;
    for (const int j : loop.ends[e].joints) {
      const Joint& joint = tree.joints[at(j)];
      const NumericPose placed = behind(pose, joint.placement, parameters);
      const double slide = evaluate(slide_of(joint), parameters);
      result.screws.push_back({j, static_cast<int>(e), turns(joint.type), slide, placed.axes[2], placed.origin});
      pose = behind_joint(placed, joint, q[at(j)], parameters);
    }
    const NumericPose end = behind(pose, loop.ends[e].placement, parameters);
    result.points[e] = end.origin;
    result.axes[e] = end.axes;
  }
  return result;
}

LoopError error_of(const Closure& closure, const LoopPosture& at, double length) {
  LoopError result;
  const Numbers3 gap = at.points[0] - at.points[1];
  const bool planar = closure.method == Closure::Method::planar;
  if (planar)
    result.rows = {dot(closure.plane[0], gap), dot(closure.plane[1], gap)};
  else
    result.rows = {(dot(gap, gap) - length * length) / (2.0 * (length > 0.0 ? length : 1.0))};
  for (const LoopScrew& screw : at.screws) {
    const Numbers3 arm = at.points[static_cast<std::size_t>(screw.end)] - screw.origin;
    Numbers3 velocity = screw.turns ? cross(screw.axis, arm) : screw.axis;
    const double sign = screw.end == 0 ? 1.0 : -1.0;
    if (planar)
      result.columns.push_back({sign * dot(closure.plane[0], velocity), sign * dot(closure.plane[1], velocity)});
    else
      result.columns.push_back({sign * dot(gap, velocity) / (length > 0.0 ? length : 1.0)});
  }
  return result;
}

double close(
    const KinematicTree& tree,
    const Closure& closure,
    std::vector<double>& q,
    const std::vector<double>& parameters) {
  const LoopJoint& loop = tree.loops[at(closure.loop())];
  const double length = evaluate(loop.length, parameters);
  constexpr int kSteps = 60;
  constexpr double kLargestStep = 0.5;  // rad, m: so that iteration reaches the nearest solution
  double gap = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    const LoopPosture now = posture(tree, loop, q, parameters);
    const LoopError error = error_of(closure, now, length);
    gap = error.rows.size() == 1 ? std::abs(error.rows[0]) : std::hypot(error.rows[0], error.rows[1]);
    std::vector<double> move = solved(closure, now, error, error.rows);
    double largest = 0.0;
    for (const double x : move) largest = std::max(largest, std::abs(x));
    if (!(largest < 1e6)) return gap;
    const double share = largest > kLargestStep ? kLargestStep / largest : 1.0;
    for (std::size_t k = 0; k < move.size(); ++k) q[at(closure.dependents[k])] -= share * move[k];
  }
  return gap;
}

std::vector<std::vector<double>> rate_factors(const Closure& closure, const LoopPosture& at, const LoopError& error) {
  std::vector<std::vector<double>> factors(closure.dependents.size(), std::vector<double>(at.screws.size()));
  for (std::size_t k = 0; k < at.screws.size(); ++k) {
    if (is_dependent(closure, at.screws[k].joint)) continue;
    const std::vector<double> rates = solved(closure, at, error, error.columns[k]);
    for (std::size_t d = 0; d < rates.size(); ++d) factors[d][k] = -rates[d];
  }
  return factors;
}

double branch_of(const KinematicTree& tree, const Closure& closure, const LoopPosture& at) {
  const std::vector<std::size_t> d = dependent_columns(closure, at);
  const auto point = [&](const LoopScrew& screw) { return at.points[static_cast<std::size_t>(screw.end)]; };
  const auto sign = [](double x) { return x < 0.0 ? -1.0 : 1.0; };
  const LoopScrew &first = at.screws[d.front()], &last = at.screws[d.back()];
  const Numbers3& other = at.points[first.end == 0 ? 1 : 0];
  if (closure.method == Closure::Method::distance) {
    if (!first.turns) return sign(dot(point(first) - other, first.axis));
    return sign(dot(first.axis, cross(other - first.origin, point(first) - first.origin)));
  }
  const auto slides = [&](const LoopScrew& screw) {
    return tree.joints[static_cast<std::size_t>(screw.joint)].type == JointType::prismatic;
  };
  if (slides(first) || slides(last)) {
    const LoopScrew &sliding = slides(first) ? first : last, &turning = slides(first) ? last : first;
    return sign(dot(point(turning) - turning.origin, sliding.axis));
  }
  const bool is_one_end = first.end == last.end;
  const Numbers3 base = (is_one_end ? other : last.origin) - first.origin;
  const Numbers3 leg = (is_one_end ? last.origin : point(first)) - first.origin;
  return sign(dot(cross(closure.plane[0], closure.plane[1]), cross(base, leg)));
}

double conditioning(const Closure& closure, const LoopPosture& at, const LoopError& error) {
  const std::vector<std::size_t> d = dependent_columns(closure, at);
  if (d.size() == 2) {
    const std::vector<double>&a = error.columns[d[0]], &b = error.columns[d[1]];
    const double sizes = std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]);
    return sizes > 0.0 ? std::abs(cross2(a, b)) / sizes : 0.0;
  }
  double largest = 0.0;
  for (const std::vector<double>& column : error.columns) largest = std::max(largest, std::abs(column[0]));
  return largest > 0.0 ? std::abs(error.columns[d[0]][0]) / largest : 0.0;
}

}  // namespace robcogen::model
