// Velocities and accelerations of a frame with respect to another. What the target does is told from each frame of the
// chain, from the last joint to the first: as seen from a frame, a joint adds to what is seen from behind it, and
// everything turns into the axes of the frame before.
#include <algorithm>

#include "algorithm/chain.h"
#include "algorithm/kinematics.h"
#include "algorithm/newton_euler.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// z x v: what turning about the z axis does to a vector.
Vector3 turned_about_z(const Vector3& v) {
  return {-v[1], v[0], Expression()};
}

// A joint's rate or acceleration, the way that the chain passes it.
Expression along(const Motor& motor, const std::vector<Expression>& values) {
  const Expression& value = values[static_cast<std::size_t>(motor.joint)];
  return motor.backward ? -value : value;
}

// The twist of a body, about the child's origin in child axes; result about the parent's. Motions move like wrenches
// with their parts exchanged.
Spatial motion_to_parent(const Pose& pose, const Spatial& motion) {
  const Spatial moved = to_parent(pose, Spatial{motion.linear, motion.angular});
  return {moved.linear, moved.angular};
}

// S x V for a joint about, or along, z.
Spatial crossed_with_joint(bool revolute, const Spatial& v) {
  if (revolute) return {turned_about_z(v.angular), turned_about_z(v.linear)};
  return {Vector3(), turned_about_z(v.angular)};
}

Spatial scaled(const Expression& factor, const Spatial& v) {
  return {factor * v.angular, factor * v.linear};
}

// The target as seen from a frame of the chain: where its origin is, and how it and the target's axes move.
struct Seen {
  Vector3 position, velocity, acceleration;
  Vector3 w, wd;
};

void add_joint(Seen& target, const Motor& motor, const Expression& rate) {
  if (!motor.revolute) {
    target.velocity[2] += rate;
    return;
  }
  const Expression twice = rate + rate, square = rate * rate;
  target.acceleration += twice * turned_about_z(target.velocity);
  target.acceleration += square * turned_about_z(turned_about_z(target.position));
  target.velocity += rate * turned_about_z(target.position);
  target.wd += rate * turned_about_z(target.w);
  target.w[2] += rate;
}

void step_back(Seen& target, const Pose& pose) {
  target.position[2] += pose.slide;
  target.position = pose.offset + to_parent(pose.rotation, target.position);
  for (Vector3* v : {&target.velocity, &target.acceleration, &target.w, &target.wd}) *v = to_parent(pose.rotation, *v);
}

// Left to right, for the derivative: a joint's axis and how the frame before it moves.
struct MovingAxis {
  Vector3 direction, point;
  Vector3 w, velocity;  // of the frame, and of its point at `point`
  bool revolute;
};

}  // namespace

Program frame_velocity(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  std::vector<Stretch> way = chain(tree, frames);
  std::reverse(way.begin(), way.end());
  Spatial twist;
  for (const Stretch& stretch : way) {
    const Pose pose = pose_of(trace, stretch, q);
    if (stretch.motor) (stretch.motor->revolute ? twist.angular : twist.linear)[2] += along(*stretch.motor, qd);
    twist = motion_to_parent(pose, twist);
  }
  trace.output("V", Role::frame_velocity, twist);
  return trace.program(name);
}

Program frame_acceleration(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  const auto qdd = trace.joint_input("qdd", Role::joint_acceleration);
  std::vector<Stretch> way = chain(tree, frames);
  std::reverse(way.begin(), way.end());
  Spatial twist, acceleration;
  for (const Stretch& stretch : way) {
    const Pose pose = pose_of(trace, stretch, q);
    if (const auto& motor = stretch.motor) {
      const Expression rate = along(*motor, qd);
      acceleration += scaled(rate, crossed_with_joint(motor->revolute, twist));
      (motor->revolute ? acceleration.angular : acceleration.linear)[2] += along(*motor, qdd);
      (motor->revolute ? twist.angular : twist.linear)[2] += rate;
    }
    twist = motion_to_parent(pose, twist);
    acceleration = motion_to_parent(pose, acceleration);
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
  std::vector<Stretch> way = chain(tree, frames);
  std::reverse(way.begin(), way.end());
  Seen target;
  for (const Stretch& stretch : way) {
    const Pose pose = pose_of(trace, stretch, q);
    if (stretch.motor) add_joint(target, *stretch.motor, along(*stretch.motor, qd));
    step_back(target, pose);
  }
  trace.output("a", Role::frame_bias_acceleration, Spatial{target.wd, target.acceleration});
  return trace.program(name);
}

Program jacobian_derivative(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  std::vector<MovingAxis> axes;
  Vector3 w, velocity, last;  // of the frame reached, and of its point at `last`
  const Reached end = walk(trace, chain(tree, frames), q, [&](const Stretch& stretch, const Reached& here) {
    const Motor& motor = *stretch.motor;
    velocity += cross(w, here.position - last);
    last = here.position;
    const Vector3 z = column(here.rotation, 2), direction = motor.backward ? -z : z;
    axes.push_back({direction, last, w, velocity, motor.revolute});
    const Vector3 added = qd[static_cast<std::size_t>(motor.joint)] * direction;
    (motor.revolute ? w : velocity) += added;
  });
  velocity += cross(w, end.position - last);
  std::vector<Expression> columns;
  for (const MovingAxis& axis : axes) {
    const Vector3 change = cross(axis.w, axis.direction);
    Vector3 linear = change;
    if (axis.revolute) {
      linear = cross(change, end.position - axis.point);
      linear += cross(axis.direction, velocity - axis.velocity);
    }
    for (const Vector3& part : {axis.revolute ? change : Vector3(), linear})
      columns.insert(columns.end(), part.element.begin(), part.element.end());
  }
  trace.output("Jd", Role::jacobian_derivative, 6, static_cast<int>(axes.size()), columns);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
