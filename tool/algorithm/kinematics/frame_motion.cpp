// Velocities and accelerations of a frame with respect to another. What the target does is told from each frame of the
// chain, from the last joint to the first: as seen from a frame, a joint adds to what is seen from behind it, and
// everything turns into the axes of the frame before.
#include <algorithm>

#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// The path with the segment of the target first.
Path path_from_target(const model::KinematicTree& tree, const model::FramePair& frames) {
  Path path = path_between(tree, frames);
  std::reverse(path.begin(), path.end());
  return path;
}

// A joint's rate or acceleration, the way that the path passes it.
Expression along(const JointOnPath& passed, const std::vector<Expression>& values) {
  const Expression& value = values[at(passed.joint)];
  return passed.backward ? -value : value;
}

// The target as seen from a frame of the chain: where its origin is, and how it and the target's axes move.
struct Seen {
  Vector3 position, velocity, acceleration;
  Vector3 w, wd;
};

// A spherical joint, of which this is the rate.
void add_rotation(Seen& target, const Vector3& rate) {
  const Vector3 velocity = cross(rate, target.position);
  target.acceleration += cross(rate, target.velocity + target.velocity + velocity);
  target.velocity += velocity;
  target.wd += cross(rate, target.w);
  target.w += rate;
}

// `own`: of the joint, which follows others.
void add_joint(Seen& target, const Joint& joint, const Expression& rate, const Expression& own, Graph& graph) {
  const auto [axis, slide] = subspace(joint, graph);
  if (!is_zero(axis)) {
    const Expression twice = rate + rate, square = rate * rate;
    target.acceleration += twice * cross(axis, target.velocity);
    target.acceleration += square * cross(axis, cross(axis, target.position));
    target.velocity += rate * cross(axis, target.position);
    target.wd += rate * cross(axis, target.w);
    target.w += rate * axis;
    target.acceleration += own * cross(axis, target.position);
    target.wd += own * axis;
  }
  target.velocity += rate * slide;
  target.acceleration += own * slide;
}

// Of a spherical joint.
Vector3 rotation_along(const std::vector<JointOnPath>& components, const std::vector<Expression>& qd) {
  Vector3 rate;
  for (std::size_t axis = 0; axis < 3; ++axis) rate[axis] = along(components[axis], qd);
  return rate;
}

void step_back(Seen& target, const Pose& pose) {
  target.position[2] += pose.slide;
  target.position = pose.offset + to_parent(pose.rotation, target.position);
  for (Vector3* v : {&target.velocity, &target.acceleration, &target.w, &target.wd}) *v = to_parent(pose.rotation, *v);
}

// Left to right, for the derivative: a joint's motion subspace in axes of the left frame, and how the frame before it
// moves.
struct MovingSubspace {
  Motion S;
  Vector3 point;
  Vector3 w, velocity;  // of the frame, and of its point at `point`
};

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
  Seen target;
  for (const PathSegment& segment : path) {
    const Pose pose = pose_of(trace, segment, q);
    if (segment.joints.size() > 1)
      add_rotation(target, rotation_along(segment.joints, qd));
    else
      for (const JointOnPath& passed : segment.joints)
        add_joint(target, joint_of(trace, passed.joint), along(passed, qd), along(passed, at_rest), trace.graph);
    step_back(target, pose);
  }
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
  const Reached end = walk(trace, path, q, [&](const PathSegment& segment, const Reached& here) {
    velocity += cross(w, here.position - last);
    last = here.position;
    std::vector<Motion> own;
    for (const auto& [joint, backward] : segment.joints) {
      joints.push_back(joint);
      own.push_back(in_axes(here.rotation, subspace(joint_of(trace, joint), trace.graph), backward));
    }
    // Axes of a spherical joint turn with its child, which is the frame reached once it has turned, or until then.
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
  output_columns(trace, "Jd", Role::jacobian_derivative, joints, by_joint);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
