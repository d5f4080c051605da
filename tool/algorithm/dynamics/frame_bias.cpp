#include "algorithm/dynamics/frame_bias.h"

#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm {

using symbolic::Role;

Vector3 origin_of(const TracedRobot& robot, const model::Frame& frame) {
  const model::KinematicTree& tree = robot.tree();
  Vector3 origin;
  if (frame.kind == model::Frame::Kind::joint)
    origin = robot.trace.lift(tree.joints[at(frame.index)].placement.translation);
  if (frame.kind == model::Frame::Kind::user)
    origin = robot.trace.lift(tree.user_frames[at(frame.index)].placement.translation);
  if (robot.frames_of_model.empty()) return origin;
  const Pose& pose = robot.frames_of_model[at(tree.link_of(frame))];
  origin[2] += pose.slide;
  return pose.offset + to_parent(pose.rotation, origin);
}

Motion acceleration_of(const TracedRobot& robot, const std::vector<LinkMotion>& motions, const model::Frame& frame) {
  const model::KinematicTree& tree = robot.tree();
  int link = tree.link_of(frame);
  robot.trace.section(frame.name, "acceleration of frame " + frame.name);
  const LinkMotion& motion = motions[at(link)];
  const Vector3 turning = multiply_u(motion.angular, origin_of(robot, frame));
  Motion result{motion.angular.wd, motion.a + turning};
  for (; !robot.is_base(link); link = tree.joints[at(tree.links[at(link)].parent_joint)].parent) {
    const Rotation& rotation = robot.pose(tree.links[at(link)].parent_joint).rotation;
    result.angular = to_parent(rotation, result.angular);
    result.linear = to_parent(rotation, result.linear);
  }
  return result;
}

symbolic::Program jacobian_with_base_bias(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const TracedRobot robot(trace, in.q);
  const Forces forces = forces_of_velocities(robot, in);
  const Motion in_base = acceleration_of(robot, forces.motions, frames.right);
  const Path to_base = path_between(tree, {frames.left, tree.frames().front()});
  const Matrix3 rotation = walk(trace, to_base, in.q, [](const PathSegment&, const PathPose&) {}).rotation;
  trace.output("a", Role::value, Motion{multiply(rotation, in_base.angular), multiply(rotation, in_base.linear)});
  return trace.program(name);
}

}  // namespace robcogen::algorithm
