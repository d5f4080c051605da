#include <algorithm>

#include "algorithm/kinematics/chain_columns.h"
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

ChainColumns chain_columns(
    Trace& trace,
    const std::vector<Expression>& q,
    const model::FramePair& frames,
    JacobianReference reference) {
  // A joint's motion subspace in the axes of the Jacobian, and its origin.
  struct Column {
    Motion S;
    Vector3 point;
  };
  // For axes of the target, the path is walked backward from the target.
  const bool back = reference == JacobianReference::in_target;
  const Path path = path_between(trace.tree, back ? model::FramePair{frames.right, frames.left} : frames);
  std::vector<Column> columns;
  ChainColumns result;
  const PathPose end = walk(trace, path, q, [&](const PathSegment& segment, const PathPose& here) {
    std::vector<JointOnPath> passed = segment.joints;
    if (back) std::reverse(passed.begin(), passed.end());
    for (const auto& [joint, backward] : passed) {
      result.joints.push_back(joint);
      const Motion S = subspace(joint_of(trace, joint), trace.graph);
      columns.push_back({in_axes(here.rotation, S, backward != back), here.position});
    }
  });
  if (back) {
    std::reverse(columns.begin(), columns.end());
    std::reverse(result.joints.begin(), result.joints.end());
  }
  if (reference == JacobianReference::in_left) result.point = end.position;
  for (const auto& [S, origin] : columns)
    result.columns.push_back({S.angular, S.linear + cross(S.angular, result.point - origin)});
  return result;
}

Program geometric_jacobian(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name,
    JacobianReference reference) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const ChainColumns chain = chain_columns(trace, q, frames, reference);
  output_columns(trace, "J", role_of(reference), chain.joints, chain.columns);
  return trace.program(name);
}

std::vector<Motion> columns_with_base(
    Trace& trace,
    const std::vector<Expression>& q,
    const model::FramePair& frames,
    JacobianReference reference) {
  const model::KinematicTree& tree = trace.tree;
  const ChainColumns chain = chain_columns(trace, q, frames, reference);
  std::vector<Motion> columns;
  if (tree.floating_base) {
    const model::Frame& seen_from = reference == JacobianReference::in_target ? frames.right : frames.left;
    const Path to_base = path_between(tree, {seen_from, tree.frames().front()});
    const PathPose base = walk(trace, to_base, q, [](const PathSegment&, const PathPose&) {});
    const Vector3 arm = chain.point - base.position;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 axis = column(base.rotation, k);
      columns.push_back({axis, cross(axis, arm)});
    }
    for (std::size_t k = 0; k < 3; ++k) columns.push_back({{}, column(base.rotation, k)});
  }
  std::vector<Motion> by_joint(tree.joints.size());
  for (std::size_t k = 0; k < chain.joints.size(); ++k) by_joint[at(chain.joints[k])] = chain.columns[k];
  for (const std::vector<MovedJoint>& moved : moved_joints(trace))
    columns.push_back(sum_of(moved, [&](int joint) { return by_joint[at(joint)]; }));
  return columns;
}

Program jacobian_with_base(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  Trace trace(tree);
  const std::vector<Motion> columns = columns_with_base(trace, trace.joint_input("q", Role::joint_position), frames);
  trace.output("J", Role::matrix, 6, static_cast<int>(columns.size()), elements_of(columns));
  return trace.program(name);
}

std::vector<Expression> elements_of(const std::vector<Motion>& columns) {
  std::vector<Expression> values;
  for (const Motion& column : columns)
    for (const Vector3& part : {column.angular, column.linear})
      values.insert(values.end(), part.element.begin(), part.element.end());
  return values;
}

void output_columns(
    Trace& trace,
    const std::string& name,
    Role role,
    const std::vector<int>& joints,
    const std::vector<Motion>& by_joint) {
  const std::vector<Motion> columns = columns_by_coordinate(trace, joints, by_joint);
  trace.output(name, role, 6, static_cast<int>(columns.size()), elements_of(columns));
}

std::vector<int> chain_coordinates(const model::KinematicTree& tree, const model::FramePair& frames) {
  std::vector<int> joints;
  for (const PathSegment& segment : path_between(tree, frames))
    for (const JointOnPath& passed : segment.joints) joints.push_back(passed.joint);
  return coordinates_of(tree, joints);
}

}  // namespace robcogen::algorithm
