#include "algorithm/kinematics/path.h"

#include <stdexcept>
#include <utility>

#include "model/rigid_motions.h"

namespace robcogen::algorithm {
namespace {

using model::PrimitiveTransform;

// The joints whose position is the amount of a primitive. A helical joint counts at its rotation; its slide is treated
// as a length.
std::vector<JointOnPath> joints_of(const model::KinematicTree& tree, const PrimitiveTransform& primitive) {
  const model::Quantity& amount = primitive.quaternion.empty() ? primitive.amount : primitive.quaternion[1];
  const bool backward = amount.op() == model::Quantity::Op::negate;
  const model::Quantity& position = backward ? amount.left() : amount;
  if (position.op() != model::Quantity::Op::variable) return {};
  const int joint = position.index();
  if (primitive.rotation != model::turns(tree.joints[at(joint)].type)) return {};
  if (primitive.quaternion.empty()) return {{joint, backward}};
  return {{joint, backward}, {joint + 1, backward}, {joint + 2, backward}};
}

}  // namespace

Path path_between(const model::KinematicTree& tree, const model::FramePair& frames) {
  const model::RigidMotions motions = model::motions_of(tree);
  return path_between(tree, model::MotionGraph(motions), frames);
}

Path path_between(const model::KinematicTree& tree, const model::MotionGraph& motions, const model::FramePair& frames) {
  const auto transform = motions.transform_between(frames.left.name, frames.right.name);
  if (!transform) throw std::logic_error("the motions of a robot do not connect its frames");
  Path path(1);
  for (const PrimitiveTransform& primitive : transform->primitives) {
    std::vector<JointOnPath> joints = joints_of(tree, primitive);
    const bool begins_next = joints.size() > 1 && joints.front().backward;
    if (!begins_next) path.back().primitives.push_back(primitive);
    if (joints.empty()) continue;
    path.back().subject = tree.joints[at(joints.front().joint)].declared_name();
    path.back().passed = "joint " + path.back().subject;
    path.back().joints = std::move(joints);
    path.emplace_back();
    if (begins_next) path.back().primitives.push_back(primitive);
  }
  return path;
}

int behind_last_turn(const Path& path) {
  int number = 0;
  for (std::size_t i = 0; i < path.size(); ++i)
    for (const PrimitiveTransform& primitive : path[i].primitives)
      if (primitive.rotation) number = static_cast<int>(i);
  const std::vector<PrimitiveTransform>& last = path[at(number)].primitives;
  const bool ends_by_turning = !last.empty() && last.back().rotation;
  return ends_by_turning && at(number) + 1 < path.size() ? number + 1 : number;
}

Pose pose_of(ProgramTrace& trace, const PathSegment& segment, const std::vector<Expression>& variables) {
  if (segment.subject.empty())
    trace.section("end", "to the last frame");
  else
    trace.section(segment.subject, "past " + segment.passed);
  return pose_of(trace, segment.primitives, variables);
}

PathPose walk(
    ProgramTrace& trace,
    const Path& path,
    const std::vector<Expression>& variables,
    const std::function<void(const PathSegment&, const PathPose&)>& behind,
    int moment_from) {
  PathPose here = start(trace.graph, moment_from);
  for (const PathSegment& segment : path) {
    advance(here, pose_of(trace, segment, variables));
    if (segment.subject.empty()) continue;
    behind(segment, here);
    name_path_pose(here, segment.subject);
  }
  return here;
}

symbolic::Program transform_along(
    const model::KinematicTree& tree,
    const Path& path,
    TransformForm form,
    const std::string& name) {
  return cheapest_transform(form, behind_last_turn(path), [&](int moment_from) {
    Trace trace(tree);
    const auto q = trace.joint_input("q", symbolic::Role::joint_position);
    output_transform(trace, path, q, form, moment_from);
    return trace.program(name);
  });
}

void output_transform(
    ProgramTrace& trace,
    const Path& path,
    const std::vector<Expression>& variables,
    TransformForm form,
    int moment_from) {
  const auto nothing = [](const PathSegment&, const PathPose&) {};
  output_transform(trace, walk(trace, path, variables, nothing, moment_from), form);
}

}  // namespace robcogen::algorithm
