#include "model/loop_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/index.h"

namespace robcogen::model {
namespace {

// Axes that differ by less than kParallel (rad) are parallel up to rounding; axes that differ by less than
// kMeantParallel are meant to be parallel.
constexpr double kParallel = 1e-9;
constexpr double kMeantParallel = 1e-3;
// As a fraction of the size of a loop.
constexpr double kSamePlane = 1e-9;

// Why a loop does not move in a plane; the text is empty if it does.
struct Reason {
  std::string text;
  bool is_rounding = false;  // the loop is meant to move in a plane
};

Reason off_plane(const std::string& what, double off) {
  if (off > kMeantParallel) return {fmt::format("the axis of '{}' is in another direction", what)};
  return {
      fmt::format(
          "the axis of '{}' is off by {:.2g} rad; write PI/2.0, for example, instead of a rounded angle", what, off),
      true};
}

double off_normal(const LoopScrew& screw, const Numbers3& normal) {
  return screw.turns ? norm(cross(screw.axis, normal)) : std::abs(dot(screw.axis, normal));
}

// Returns why the joints of a loop do not move its links in the plane with this normal; empty if they do.
Reason reason_against(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const LoopPosture& posture,
    const Numbers3& normal) {
  for (const LoopScrew& screw : posture.screws) {
    const Joint& joint = tree.joints[at(screw.joint)];
    if (joint.type != JointType::revolute && joint.type != JointType::prismatic)
      return {fmt::format("joint '{}' is neither revolute nor prismatic", joint.name)};
    const double off = off_normal(screw, normal);
    if (off > kParallel) return off_plane(joint.name, off);
  }
  for (std::size_t e = 0; loop.type == LoopType::hinge && e < 2; ++e) {
    const double off = norm(cross(posture.axes[e][2], normal));
    if (off > kMeantParallel)
      return {fmt::format(
          "the z axis of '{}', about which the hinge turns, is not parallel to the axes of its joints",
          loop.ends[e].frame)};
    if (off > kParallel) return off_plane(loop.ends[e].frame, off);
  }
  return {};
}

double gap_along(const LoopPosture& posture, const Numbers3& normal) {
  const double gap = std::abs(dot(normal, posture.points[0] - posture.points[1]));
  return gap > kSamePlane * size_of(posture) ? gap : 0.0;
}

// Sets the axes of the plane and the senses of the joints. The axes are coordinate axes if the normal is one.
void span(const LoopPosture& posture, Numbers3 normal, Closure& closure) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(normal[i]) > std::abs(normal[largest])) largest = i;
  if (normal[largest] < 0.0)
    for (double& x : normal) x = -x;
  if (normal[largest] > 1.0 - kParallel * kParallel) {
    normal = {};
    normal[largest] = 1.0;
  }
  Numbers3 first{};
  first[(largest + 1) % 3] = 1.0;
  const double along = dot(first, normal);
  for (std::size_t i = 0; i < 3; ++i) first[i] -= along * normal[i];
  const double length = norm(first);
  for (double& x : first) x /= length;
  closure.plane = {first, cross(normal, first)};
  for (const LoopScrew& screw : posture.screws) {
    const int sense = dot(screw.axis, normal) > 0.0 ? 1 : -1;
    closure.senses[static_cast<std::size_t>(screw.end)].push_back(screw.turns ? sense : 0);
  }
}

}  // namespace

PlaneFault find_plane(
    const KinematicTree& tree,
    const LoopJoint& loop,
    const std::vector<double>& parameters,
    Closure& closure) {
  const std::vector<double> zeros(tree.joints.size());
  const LoopPosture start = posture(tree, loop, zeros, parameters);
  const auto turning =
      std::find_if(start.screws.begin(), start.screws.end(), [](const LoopScrew& screw) { return screw.turns; });
  const bool turns = turning != start.screws.end();
  const Reason reason = turns ? reason_against(tree, loop, start, turning->axis) : Reason{"none of its joints turns"};
  if (!reason.text.empty())
    return {
        "loop-not-planar", fmt::format("loop '{}' does not move in a plane: {}", loop.name, reason.text), "",
        !reason.is_rounding};
  const Numbers3 normal = turning->axis;
  if (const double gap = gap_along(start, normal); gap > 0.0)
    return open_loop(loop, gap, "at q = 0", " along the axes of its joints");
  std::vector<double> others = parameters;
  for (std::size_t k = 0; k < others.size(); ++k) others[k] += 0.05 + 0.01 * static_cast<double>(k);
  const LoopPosture moved = posture(tree, loop, zeros, others);
  if (!reason_against(tree, loop, moved, normal).text.empty() || gap_along(moved, normal) > 0.0)
    return {
        "loop-plane-of-parameters", fmt::format("the plane in which loop '{}' moves depends on parameters", loop.name),
        "parameters may be lengths in the plane, and angles about the axes of the joints"};
  span(start, normal, closure);
  return {};
}

double gap_of(const LoopJoint& loop, const LoopPosture& posture, double length, double error) {
  if (loop.type != LoopType::distance) return error;
  return std::abs(norm(posture.points[0] - posture.points[1]) - length);
}

PlaneFault open_loop(const LoopJoint& loop, double gap, const std::string& where, const std::string& along) {
  return {
      "loop-cannot-close",
      fmt::format(
          "loop '{}' does not close {}: '{}' misses '{}' by {:.3g} m{}", loop.name, where, loop.ends[0].frame,
          loop.ends[1].frame, gap, along),
      "check lengths and frames"};
}

double size_of(const LoopPosture& posture) {
  double size = norm(posture.points[0] - posture.points[1]);
  for (const LoopScrew& screw : posture.screws)
    size = std::max(size, norm(posture.points[static_cast<std::size_t>(screw.end)] - screw.origin));
  return size;
}

}  // namespace robcogen::model
