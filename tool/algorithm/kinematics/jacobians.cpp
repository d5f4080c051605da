#include <algorithm>

#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/path.h"
#include "algorithm/spatial/couplings.h"

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
  return transform_along(tree, path_between(tree, frames), form, name);
}

Program geometric_jacobian(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name,
    JacobianReference reference) {
  // A joint's motion subspace in the axes that the Jacobian is in, and its origin.
  struct Column {
    Motion S;
    Vector3 point;
  };
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  // In axes of the target everything is seen from there, on the way back.
  const bool back = reference == JacobianReference::in_target;
  const Path path = path_between(tree, back ? model::FramePair{frames.right, frames.left} : frames);
  std::vector<Column> columns;
  std::vector<int> joints;
  const Reached end = walk(trace, path, q, [&](const PathSegment& segment, const Reached& here) {
    const bool negated = segment.joint->backward != back;
    joints.push_back(segment.joint->joint.index);
    columns.push_back({in_axes(here.rotation, subspace(segment.joint->joint, trace.graph), negated), here.position});
  });
  if (back) {
    std::reverse(columns.begin(), columns.end());
    std::reverse(joints.begin(), joints.end());
  }
  // Whose velocity the linear part is: that of the target's origin, or of the target's point at the left origin.
  const Vector3 point = reference == JacobianReference::in_left ? end.position : Vector3();
  std::vector<Motion> by_joint;
  for (const auto& [S, origin] : columns) by_joint.push_back({S.angular, S.linear + cross(S.angular, point - origin)});
  output_columns(trace, "J", role_of(reference), joints, by_joint);
  return trace.program(name);
}

void output_columns(
    Trace& trace,
    const std::string& name,
    Role role,
    const std::vector<int>& joints,
    const std::vector<Motion>& by_joint) {
  const std::vector<Motion> columns = columns_by_coordinate(trace, joints, by_joint);
  std::vector<Expression> values;
  for (const Motion& column : columns)
    for (const Vector3& part : {column.angular, column.linear})
      values.insert(values.end(), part.element.begin(), part.element.end());
  trace.output(name, role, 6, static_cast<int>(columns.size()), values);
}

std::vector<int> chain_coordinates(const model::KinematicTree& tree, const model::FramePair& frames) {
  std::vector<int> joints;
  for (const PathSegment& segment : path_between(tree, frames))
    if (segment.joint) joints.push_back(segment.joint->joint.index);
  return coordinates_of(tree, joints);
}

}  // namespace robcogen::algorithm
