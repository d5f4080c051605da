#include "algorithm/kinematics/loop_functions.h"

#include "algorithm/kinematics/chain_columns.h"
#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

model::FramePair frames_of(const model::KinematicTree& tree, const model::LoopJoint& loop) {
  return {*tree.find_frame(loop.ends[0].frame), *tree.find_frame(loop.ends[1].frame)};
}

// By joint.
std::vector<Expression> all_positions(Trace& trace) {
  const std::vector<int> order = model::independent_joints_first(trace.tree);
  std::vector<std::string> names;
  for (const int joint : order) names.push_back(trace.tree.joints[at(joint)].name);
  const std::vector<Expression> given = trace.input("positions", Role::value, names);
  std::vector<Expression> q(given.size());
  for (std::size_t k = 0; k < order.size(); ++k) q[at(order[k])] = given[k];
  return q;
}

// The second frame in the first one.
Reached second_in_first(Trace& trace, const model::LoopJoint& loop, const std::vector<Expression>& q) {
  const Path path = path_between(trace.tree, frames_of(trace.tree, loop));
  return walk(trace, path, q, [](const PathSegment&, const Reached&) {});
}

std::vector<Expression> error_of(Trace& trace, const model::LoopJoint& loop, const std::vector<Expression>& q) {
  const Reached second = second_in_first(trace, loop, q);
  const Vector3& p = second.position;
  if (loop.type == model::LoopType::distance) return {sqrt(dot(p, p)) - trace.lift(loop.length)};
  std::vector<Expression> rows(p.element.begin(), p.element.end());
  if (loop.type == model::LoopType::hinge) {
    const Vector3 axis = column(second.rotation, 2);
    rows.insert(rows.end(), {axis[0], axis[1]});
  }
  return rows;
}

// By joint of the chain.
std::vector<std::vector<Expression>> columns_of(
    Trace& trace,
    const model::LoopJoint& loop,
    const std::vector<Expression>& q,
    std::vector<int>& joints) {
  const ChainColumns chain = chain_columns(trace, q, frames_of(trace.tree, loop), JacobianReference::in_left);
  joints = chain.joints;
  std::vector<std::vector<Expression>> result;
  if (loop.type == model::LoopType::distance) {
    const Vector3& p = chain.point;
    const Vector3 direction = (trace.graph.one() / sqrt(dot(p, p))) * p;
    for (const Motion& column : chain.columns) result.push_back({dot(direction, column.linear)});
    return result;
  }
  Vector3 axis;
  if (loop.type == model::LoopType::hinge) axis = column(second_in_first(trace, loop, q).rotation, 2);
  for (const Motion& column : chain.columns) {
    std::vector<Expression>& rows = result.emplace_back(column.linear.element.begin(), column.linear.element.end());
    if (loop.type != model::LoopType::hinge) continue;
    const Vector3 turned = cross(column.angular, axis);
    rows.insert(rows.end(), {turned[0], turned[1]});
  }
  return result;
}

void output_of_all_joints(Trace& trace, const std::string& name, const std::vector<Expression>& by_joint) {
  std::vector<Expression> values;
  for (const int joint : model::independent_joints_first(trace.tree)) values.push_back(by_joint[at(joint)]);
  trace.output(name, Role::value, values);
}

}  // namespace

int rows_of(model::LoopType type) {
  return type == model::LoopType::distance ? 1 : type == model::LoopType::hinge ? 5 : 3;
}

Program loop_error(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = all_positions(trace);
  std::vector<Expression> errors;
  for (const model::LoopJoint& loop : tree.loops)
    for (const Expression& row : error_of(trace, loop, q)) errors.push_back(row);
  trace.output("error", Role::value, errors);
  return trace.program(name);
}

Program loop_jacobian(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = all_positions(trace);
  Columns by_joint(tree.joints.size());
  std::size_t first = 0;
  for (const model::LoopJoint& loop : tree.loops) {
    std::vector<int> joints;
    const auto columns = columns_of(trace, loop, q, joints);
    first += at(rows_of(loop.type));
    for (std::size_t k = 0; k < joints.size(); ++k)
      by_joint[at(joints[k])].insert(by_joint[at(joints[k])].end(), columns[k].begin(), columns[k].end());
    for (std::vector<Expression>& column : by_joint) column.resize(first);
  }
  Columns columns;
  for (const int joint : model::independent_joints_first(tree)) columns.push_back(by_joint[at(joint)]);
  trace.output("K", Role::matrix, static_cast<int>(first), columns);
  return trace.program(name);
}

Program joint_velocities(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  trace.joint_input("q", Role::joint_position);
  output_of_all_joints(trace, "velocities", trace.joint_input("qd", Role::joint_velocity));
  return trace.program(name);
}

Program joint_accelerations(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  trace.joint_input("q", Role::joint_position);
  trace.joint_input("qd", Role::joint_velocity);
  output_of_all_joints(trace, "accelerations", trace.joint_input("qdd", Role::joint_acceleration));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
