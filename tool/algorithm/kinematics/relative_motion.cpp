#include "algorithm/kinematics/relative_motion.h"

#include <algorithm>

namespace robcogen::algorithm {
namespace {

// Adds a spherical joint with angular velocity `rate` and its derivative `own`.
void add_rotation(RelativeMotion& target, const Vector3& rate, const Vector3& own) {
  const Vector3 velocity = cross(rate, target.position);
  target.acceleration += cross(rate, target.velocity + target.velocity + velocity);
  target.velocity += velocity;
  target.wd += cross(rate, target.w);
  target.w += rate;
  target.acceleration += cross(own, target.position);
  target.wd += own;
}

void add_joint(
    RelativeMotion& target,
    const Joint& joint,
    const Expression& rate,
    const Expression& own,
    Graph& graph) {
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

// The values of the components of a spherical joint as a vector.
Vector3 rotation_along(const std::vector<JointOnPath>& components, const std::vector<Expression>& values) {
  Vector3 rotation;
  for (std::size_t axis = 0; axis < 3; ++axis) rotation[axis] = along(components[axis], values);
  return rotation;
}

void step_back(RelativeMotion& target, const Pose& pose) {
  target.position[2] += pose.slide;
  target.position = pose.offset + to_parent(pose.rotation, target.position);
  for (Vector3* v : {&target.velocity, &target.acceleration, &target.w, &target.wd}) *v = to_parent(pose.rotation, *v);
}

}  // namespace

Path path_from_target(const model::KinematicTree& tree, const model::FramePair& frames) {
  Path path = path_between(tree, frames);
  std::reverse(path.begin(), path.end());
  return path;
}

Expression along(const JointOnPath& passed, const std::vector<Expression>& values) {
  const Expression& value = values[at(passed.joint)];
  return passed.backward ? -value : value;
}

RelativeMotion relative_motion(
    Trace& trace,
    const Path& path,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd) {
  RelativeMotion target;
  for (const PathSegment& segment : path) {
    const Pose pose = pose_of(trace, segment, q);
    if (segment.joints.size() > 1)
      add_rotation(target, rotation_along(segment.joints, qd), rotation_along(segment.joints, qdd));
    else
      for (const JointOnPath& passed : segment.joints)
        add_joint(target, joint_of(trace, passed.joint), along(passed, qd), along(passed, qdd), trace.graph);
    step_back(target, pose);
  }
  return target;
}

}  // namespace robcogen::algorithm
