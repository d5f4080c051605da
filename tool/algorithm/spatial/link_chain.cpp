#include "algorithm/spatial/link_chain.h"

namespace robcogen::algorithm {
namespace {

using model::Axis;
using model::PrimitiveTransform;
using model::Quantity;

constexpr std::array kAxes3 = {Axis::x, Axis::y, Axis::z};

std::vector<PrimitiveTransform> primitives(const model::Placement& placement) {
  std::vector<PrimitiveTransform> result;
  for (const bool rotation : {false, true}) {
    const auto& amounts = rotation ? placement.rotation : placement.translation;
    for (std::size_t i = 0; i < 3; ++i)
      if (!amounts[i].is_zero()) result.push_back({rotation, kAxes3[i], amounts[i]});
  }
  return result;
}

std::vector<PrimitiveTransform> with_travel(const model::Joint& joint, int index) {
  std::vector<PrimitiveTransform> result = primitives(joint.placement);
  const Quantity position = Quantity::variable(index);
  if (model::turns(joint.type)) result.push_back({true, Axis::z, position});
  const Quantity slide = model::slide_of(joint) * position;
  if (!slide.is_zero()) result.push_back({false, Axis::z, slide});
  return result;
}

}  // namespace

std::vector<Pose> placements_at_zero(Trace& trace, const model::LoopEnd& end) {
  std::vector<Pose> poses;
  for (const int joint : end.joints) poses.push_back(placement_of_joint(trace, joint));
  poses.push_back(pose_of(trace, primitives(end.placement), {}));
  return poses;
}

std::vector<Pose> poses_along(Trace& trace, const model::LoopEnd& end, const std::vector<Expression>& q) {
  std::vector<Pose> poses;
  for (const int joint : end.joints)
    poses.push_back(pose_of(trace, with_travel(trace.tree.joints[at(joint)], joint), q));
  poses.push_back(pose_of(trace, primitives(end.placement), {}));
  return poses;
}

Pose placement_of_joint(Trace& trace, int joint) {
  return pose_of(trace, primitives(trace.tree.joints[at(joint)].placement), {});
}

Vector3 point_through(const std::vector<Pose>& poses, std::size_t k, Vector3 point) {
  for (std::size_t i = k + 1; i-- > 0;) point = point_to_parent(poses[i], point);
  return point;
}

Vector3 direction_through(const std::vector<Pose>& poses, std::size_t k, Vector3 direction) {
  for (std::size_t i = k + 1; i-- > 0;) direction = to_parent(poses[i].rotation, direction);
  return direction;
}

Vector3 point_to_parent(const Pose& X_PC, Vector3 point) {
  point[2] += X_PC.slide;
  return X_PC.offset + to_parent(X_PC.rotation, point);
}

Vector3 point_to_child(const Pose& X_PC, const Vector3& point) {
  Vector3 result = to_child(X_PC.rotation, point - X_PC.offset);
  result[2] -= X_PC.slide;
  return result;
}

}  // namespace robcogen::algorithm
