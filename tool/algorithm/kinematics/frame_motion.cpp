// Velocities and accelerations of a frame with respect to another, from the last joint of the chain to the first.
#include <algorithm>

#include "algorithm/kinematics/chain_columns.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/path.h"
#include "algorithm/kinematics/relative_motion.h"
#include "algorithm/spatial/couplings.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// A joint's motion subspace in axes of the left frame, and the motion of the frame before it; for the derivative, from
// left to right.
struct MovingSubspace {
  Motion S;
  Vector3 point;
  Vector3 w, velocity;  // of the frame, and of its point at `point`
};

// A joint's column of the Jacobian of a frame at `position`.
Motion column_of(const MovingSubspace& joint, const Vector3& position) {
  return {joint.S.angular, joint.S.linear + cross(joint.S.angular, position - joint.point)};
}

// Adds J dG/dt: through loops, joints move with others in a proportion that changes.
void add_changes_of_shares(
    Trace& trace,
    const std::vector<int>& joints,
    const std::vector<Motion>& J,
    const std::vector<Expression>& qd,
    std::vector<Motion>& by_coordinate) {
  const std::vector<std::vector<MovedJoint>> changes = moved_joint_rates(trace, qd);
  const std::vector<int> coordinates = coordinates_of(trace.tree, joints);
  for (std::size_t k = 0; k < coordinates.size(); ++k)
    for (const MovedJoint& change : changes[at(coordinates[k])])
      for (std::size_t i = 0; i < joints.size(); ++i)
        if (joints[i] == change.joint) by_coordinate[k] += change.factor * J[i];
}

}  // namespace

Program frame_velocity(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  const Path path = path_from_target(tree, frames);
  Motion twist;
  for (const PathSegment& segment : path) {
    const Pose pose = pose_of(trace, segment, q);
    for (const JointOnPath& passed : segment.joints) add_rate(joint_of(trace, passed.joint), along(passed, qd), twist);
    twist = to_parent(pose, twist);
  }
  trace.output("V", Role::frame_velocity, twist);
  return trace.program(name);
}

Program frame_acceleration(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  const auto qdd = trace.joint_input("qdd", Role::joint_acceleration);
  const Path path = path_from_target(tree, frames);
  Motion twist, acceleration;
  for (const PathSegment& segment : path) {
    const Pose pose = pose_of(trace, segment, q);
    const Motion beyond = twist;
    for (const JointOnPath& passed : segment.joints) {
      const Joint joint = joint_of(trace, passed.joint);
      const Expression rate = along(passed, qd);
      acceleration += rate * cross_subspace(joint, beyond);
      add_rate(joint, along(passed, qdd), acceleration);
      add_rate(joint, rate, twist);
    }
    twist = to_parent(pose, twist);
    acceleration = to_parent(pose, acceleration);
  }
  trace.output("A", Role::frame_acceleration, acceleration);
  return trace.program(name);
}

Program jacobian_derivative_times_velocity(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  const Path path = path_from_target(tree, frames);
  const std::vector<Expression> at_rest = trace.accelerations_at_rest();
  const RelativeMotion target = relative_motion(trace, path, q, qd, at_rest);
  trace.output("a", Role::frame_bias_acceleration, Motion{target.wd, target.acceleration});
  return trace.program(name);
}

Program jacobian_derivative(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  std::vector<MovingSubspace> columns;
  std::vector<int> joints;
  Vector3 w, velocity, last;  // of the frame reached, and of its point at `last`
  const Path path = path_between(tree, frames);
  const PathPose end = walk(trace, path, q, [&](const PathSegment& segment, const PathPose& here) {
    velocity += cross(w, here.position - last);
    last = here.position;
    std::vector<Motion> own;
    for (const auto& [joint, backward] : segment.joints) {
      joints.push_back(joint);
      own.push_back(in_axes(here.rotation, subspace(joint_of(trace, joint), trace.graph), backward));
    }
    // The axes of a spherical joint turn with its child. That is the frame after the joint or, if the joint is passed
    // backward, the frame before it.
    const bool turn_with_reached = own.size() > 1 && !segment.joints.front().backward;
    const auto add_columns = [&] {
      for (const Motion& S : own) columns.push_back({S, last, w, velocity});
    };
    if (!turn_with_reached) add_columns();
    for (std::size_t k = 0; k < own.size(); ++k) {
      const Expression& rate = qd[at(segment.joints[k].joint)];
      w += rate * own[k].angular;
      velocity += rate * own[k].linear;
    }
    if (turn_with_reached) add_columns();
  });
  velocity += cross(w, end.position - last);
  std::vector<Motion> by_joint;
  for (const MovingSubspace& column : columns) {
    const Vector3 angular = cross(column.w, column.S.angular);
    Vector3 linear = cross(column.w, column.S.linear);
    linear += cross(angular, end.position - column.point);
    linear += cross(column.S.angular, velocity - column.velocity);
    by_joint.push_back({angular, linear});
  }
  std::vector<Motion> by_coordinate = columns_by_coordinate(trace, joints, by_joint);
  if (tree.has_closures()) {
    std::vector<Motion> J;
    for (const MovingSubspace& column : columns) J.push_back(column_of(column, end.position));
    add_changes_of_shares(trace, joints, J, qd, by_coordinate);
  }
  trace.output("Jd", Role::jacobian_derivative, 6, static_cast<int>(by_coordinate.size()), elements_of(by_coordinate));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
