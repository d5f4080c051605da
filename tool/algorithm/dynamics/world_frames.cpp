#include "algorithm/dynamics/world_frames.h"

#include <algorithm>

#include "algorithm/dynamics/frame_bias.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/kinematics/chain_columns.h"
#include "algorithm/kinematics/relative_motion.h"
#include "algorithm/spatial/couplings.h"

namespace robcogen::algorithm {
namespace {

using model::Frame;
using model::KinematicTree;
using symbolic::Program;
using symbolic::Role;

Frame base_frame(const KinematicTree& tree) {
  return tree.frames().front();
}

// The motion of a frame relative to the base.
RelativeMotion motion_in_base(
    Trace& trace,
    const Frame& frame,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd) {
  return relative_motion(trace, path_from_target(trace.tree, {base_frame(trace.tree), frame}), q, qd, qdd);
}

// The joints from the base to a link.
std::vector<int> joints_to(const KinematicTree& tree, int link) {
  std::vector<int> joints;
  for (int j = tree.links[at(link)].parent_joint; j >= 0; j = tree.parent_joint_of(j)) joints.push_back(j);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

// The pose of a frame in its link.
Pose pose_in_link(Trace& trace, const Frame& frame) {
  const int link = trace.tree.link_of(frame);
  const Frame own = {Frame::Kind::link, link, model::implicit_frame_name(trace.tree.links[at(link)].name)};
  return pose_of(trace, path_between(trace.tree, {own, frame}).back(), {});
}

void output_in_world(Trace& trace, const StateInputs& in, const char* name, const Motion& in_base) {
  trace.section("world", "in axes of the world");
  trace.output(name, Role::value, in_axes(in.base_rotation, in_base, false));
}

// The velocity of a frame in axes of the base, angular and of its origin, from its motion relative to the base.
Motion velocity_with_base(const StateInputs& in, const RelativeMotion& frame) {
  const Vector3 &w = in.base_velocity.angular, &v = in.base_velocity.linear;
  return {w + frame.w, v + cross(w, frame.position) + frame.velocity};
}

// The acceleration, with centripetal and Coriolis acceleration in the moving base (Siciliano et al., Robotics, 2009,
// 7.2.1); the acceleration of the base is spatial.
Motion acceleration_with_base(const StateInputs& in, const RelativeMotion& frame) {
  const auto& [w, v] = in.base_velocity;
  const auto& [wd, vd] = in.base_acceleration;
  const Vector3 twice = frame.velocity + frame.velocity;
  const Vector3 linear = vd + cross(wd, frame.position) + frame.acceleration;
  return {wd + cross(w, frame.w) + frame.wd, linear + cross(w, v + cross(w, frame.position) + twice)};
}

// The acceleration in axes of the frame: by the recursion to its link, and from there to the frame.
Motion acceleration_in_frame(
    Trace& trace,
    const StateInputs& in,
    const std::vector<Expression>& qdd,
    const Frame& frame) {
  const TracedRobot robot(trace, in.q);
  LinkMotion motion = base_motion(in.base_velocity, in.base_acceleration, {});
  for (const int j : joints_to(trace.tree, trace.tree.link_of(frame))) {
    trace.section(robot.link_name(trace.tree.joints[at(j)].child), "past joint " + trace.tree.joints[at(j)].name);
    motion = across_joint(robot.joint(j), robot.pose(j), motion, in.qd, qdd);
  }
  const Pose in_link = pose_in_link(trace, frame);
  motion = carried_motion(in_link, motion);
  return {motion.angular.wd, motion.a + multiply_u(motion.angular, {Expression(), Expression(), in_link.slide})};
}

Program acceleration(const KinematicTree& tree, const Frame& frame, Axes axes, bool is_bias, const std::string& name) {
  const bool of_world = axes == Axes::of_world;
  Trace trace(tree);
  std::vector<State> list = {State::position, State::velocity};
  if (!is_bias) list.push_back(State::acceleration);
  if (of_world) list.push_back(State::base_pose);
  list.push_back(State::base_velocity);
  if (!is_bias) list.push_back(State::base_acceleration);
  const StateInputs in(trace, list);
  const std::vector<Expression> qdd = is_bias ? trace.accelerations_at_rest() : in.qdd;
  if (of_world) {
    output_in_world(trace, in, "a", acceleration_with_base(in, motion_in_base(trace, frame, in.q, in.qd, qdd)));
  } else {
    trace.output("a", Role::value, acceleration_in_frame(trace, in, qdd, frame));
  }
  return trace.program(name);
}

// The acceleration of a frame, less gravity, in its own axes: angular, and of its origin.
Motion proper_acceleration(const TracedRobot& robot, const LinkMotion& motion, const Frame& frame) {
  const int link = robot.tree().link_of(frame);
  Motion a{motion.angular.wd, motion.a + multiply_u(motion.angular, origin_of(robot, frame))};
  const auto turn = [&](const Rotation& rotation) {
    a = {to_child(rotation, a.angular), to_child(rotation, a.linear)};
  };
  if (!robot.frames_of_model.empty()) turn(robot.frames_of_model[at(link)].rotation);
  turn(pose_in_link(robot.trace, frame).rotation);
  return a;
}

}  // namespace

Program bias_from_forces(
    const KinematicTree& tree,
    const model::FramePair& frames,
    BiasAxes axes,
    Role role,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  std::vector<State> list = {State::position, State::velocity};
  if (axes == BiasAxes::of_world) list.push_back(State::base_pose);
  list.push_back(State::base_velocity);
  const StateInputs in(trace, list);
  const LoadInputs load(trace, std::min(loads, Loads::gravity));
  const TracedRobot robot(trace, in.q, formulation);
  const std::vector<Expression> at_rest = trace.accelerations_at_rest();
  LinkMotion motion = base_motion(in.base_velocity, {}, load.gravity);
  for (const int j : joints_to(tree, tree.link_of(frames.right)))
    motion = across_joint(robot.joint(j), robot.pose(j), motion, in.qd, at_rest);
  Motion a = proper_acceleration(robot, motion, frames.right);
  const Frame left = axes == BiasAxes::of_left ? frames.left : base_frame(tree);
  const Matrix3 rotation =
      walk(trace, path_between(tree, {left, frames.right}), in.q, [](const PathSegment&, const PathPose&) {}).rotation;
  trace.section(frames.right.name, "acceleration of frame " + frames.right.name);
  const Vector3 gravity = to_child(pose_in_link(trace, left).rotation, load.gravity);
  if (axes == BiasAxes::of_frame) {
    for (std::size_t k = 0; k < 3; ++k) a.linear[k] += dot(column(rotation, k), gravity);
  } else {
    a = {multiply(rotation, a.angular), multiply(rotation, a.linear) + gravity};
  }
  if (axes == BiasAxes::of_world) a = in_axes(in.base_rotation, a, false);
  trace.output("a", role, a);
  return trace.program(name);
}

namespace {

// A rotation and a position as a matrix of 4 x 4, column by column.
std::vector<Expression> homogeneous(Graph& graph, const Matrix3& R, const Vector3& p) {
  std::vector<Expression> X;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t r = 0; r < 3; ++r) X.push_back(c < 3 ? R[r][c] : p[r]);
    X.push_back(c < 3 ? Expression() : graph.one());
  }
  return X;
}

}  // namespace

// Paths that begin alike compute the same poses.
Program world_transforms(const KinematicTree& tree, const std::vector<Frame>& frames, const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::base_pose});
  for (const Frame& frame : frames) {
    PathPose here = start(trace.graph);
    here.rotation = in.base_rotation;
    here.position = in.base_position;
    for (const PathSegment& segment : path_between(tree, {base_frame(tree), frame}))
      advance(here, pose_of(trace, segment, in.q));
    trace.output("X_" + frame.name, Role::matrix, 4, 4, homogeneous(trace.graph, here.rotation, here.position));
  }
  return trace.program(name);
}

Program world_transform(const KinematicTree& tree, const Frame& frame, const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::base_pose});
  const Path path = path_between(tree, {base_frame(tree), frame});
  const PathPose end = walk(trace, path, in.q, [](const PathSegment&, const PathPose&) {});
  trace.section("world", "in the world");
  const Matrix3 R = in.base_rotation * end.rotation;
  const Vector3 p = in.base_position + multiply(in.base_rotation, end.position);
  trace.output("X", Role::matrix, 4, 4, homogeneous(trace.graph, R, p));
  return trace.program(name);
}

Program world_position(const KinematicTree& tree, const Frame& frame, const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::base_pose});
  const std::vector<Expression> none(tree.joints.size());
  const RelativeMotion motion = motion_in_base(trace, frame, in.q, none, none);
  trace.section("world", "in the world");
  const Vector3 p = in.base_position + multiply(in.base_rotation, motion.position);
  trace.output("p", Role::position, std::vector<Expression>(p.element.begin(), p.element.end()));
  return trace.program(name);
}

Program world_velocity(const KinematicTree& tree, const Frame& frame, Axes axes, const std::string& name) {
  Trace trace(tree);
  if (axes == Axes::of_world) {
    const StateInputs in(trace, {State::position, State::velocity, State::base_pose, State::base_velocity});
    const std::vector<Expression> none(tree.joints.size());
    output_in_world(trace, in, "v", velocity_with_base(in, motion_in_base(trace, frame, in.q, in.qd, none)));
    return trace.program(name);
  }
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const TracedRobot robot(trace, in.q);
  Motion V = in.base_velocity;
  for (const int j : joints_to(tree, tree.link_of(frame))) {
    trace.section(robot.link_name(tree.joints[at(j)].child), "past joint " + tree.joints[at(j)].name);
    V = across_joint(robot.joint(j), robot.pose(j), V, in.qd);
  }
  trace.output("v", Role::value, to_child(pose_in_link(trace, frame), V));
  return trace.program(name);
}

Program world_acceleration(const KinematicTree& tree, const Frame& frame, Axes axes, const std::string& name) {
  return acceleration(tree, frame, axes, false, name);
}

Program world_bias(const KinematicTree& tree, const Frame& frame, Axes axes, const std::string& name) {
  return acceleration(tree, frame, axes, true, name);
}

Program world_jacobian(const KinematicTree& tree, const Frame& frame, Axes axes, const std::string& name) {
  Trace trace(tree);
  const model::FramePair frames = {base_frame(tree), frame};
  std::vector<Motion> columns;
  if (axes == Axes::of_world) {
    const StateInputs in(trace, {State::position, State::base_pose});
    const std::vector<Motion> in_base = columns_with_base(trace, in.q, frames);
    trace.section("world", "in axes of the world");
    for (const Motion& column : in_base) columns.push_back(in_axes(in.base_rotation, column, false));
  } else {
    columns =
        columns_with_base(trace, trace.joint_input("q", Role::joint_position), frames, JacobianReference::in_target);
  }
  trace.output("J", Role::matrix, 6, static_cast<int>(columns.size()), elements_of(columns));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
