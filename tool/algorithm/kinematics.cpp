#include "algorithm/kinematics.h"

#include <algorithm>

#include "algorithm/chain.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

Role role_of(JacobianReference reference) {
  switch (reference) {
    case JacobianReference::in_target:
      return Role::jacobian_in_target;
    case JacobianReference::spatial:
      return Role::spatial_jacobian;
    default:
      return Role::jacobian;
  }
}

}  // namespace

Program coordinate_transform(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    TransformForm form,
    const std::string& name) {
  return transform_along(tree, chain(tree, frames), form, name);
}

Program geometric_jacobian(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name,
    JacobianReference reference) {
  struct Axis {
    Vector3 direction;
    Vector3 point;
    bool revolute;
  };
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  // In axes of the target everything is told from there, on the way back.
  const bool back = reference == JacobianReference::in_target;
  const std::vector<Stretch> way = chain(tree, back ? model::FramePair{frames.right, frames.left} : frames);
  std::vector<Axis> axes;
  const Reached end = walk(trace, way, q, [&](const Stretch& stretch, const Reached& here) {
    const Vector3 z = column(here.rotation, 2);
    axes.push_back({stretch.motor->backward != back ? -z : z, here.position, stretch.motor->revolute});
  });
  if (back) std::reverse(axes.begin(), axes.end());
  // Whose velocity the linear part is: that of the target's origin, or of the target's point at the left origin.
  const Vector3 point = reference == JacobianReference::in_left ? end.position : Vector3();
  std::vector<Expression> columns;
  for (const Axis& axis : axes) {
    const Vector3 angular = axis.revolute ? axis.direction : Vector3();
    const Vector3 linear = axis.revolute ? cross(axis.direction, point - axis.point) : axis.direction;
    for (const Vector3& part : {angular, linear})
      columns.insert(columns.end(), part.element.begin(), part.element.end());
  }
  trace.output("J", role_of(reference), 6, static_cast<int>(axes.size()), columns);
  return trace.program(name);
}

std::vector<int> chain_joints(const model::KinematicTree& tree, const model::FramePair& frames) {
  std::vector<int> joints;
  for (const Stretch& stretch : chain(tree, frames))
    if (stretch.motor) joints.push_back(stretch.motor->joint);
  return joints;
}

}  // namespace robcogen::algorithm
