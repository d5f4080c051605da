#include "model/rigid_motions.h"

#include <algorithm>

#include "support/index.h"

namespace robcogen::model {

namespace {

// trx try trz rotx roty rotz, without steps of zero.
std::vector<ElementaryMotion> steps_of(const Placement& placement) {
  std::vector<ElementaryMotion> steps;
  for (const bool rotation : {false, true}) {
    const auto& amounts = rotation ? placement.rotation : placement.translation;
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      const Quantity& amount = amounts[static_cast<std::size_t>(axis)];
      if (!amount.is_zero()) steps.push_back({rotation, axis, amount});
    }
  }
  return steps;
}

// A name different from those of all parameters.
std::string variable_name(const KinematicTree& tree, const Joint& joint) {
  std::string name = "q_" + joint.name;
  const auto is_taken = [&] {
    return std::any_of(
        tree.parameters.begin(), tree.parameters.end(), [&](const Parameter& p) { return p.name == name; });
  };
  while (is_taken()) name += "_";
  return name;
}

}  // namespace

RigidMotions motions_of(const KinematicTree& tree) {
  RigidMotions motions;
  motions.name = tree.name;
  motions.convention = MotionConvention::local;
  motions.parameters = tree.parameters;
  for (const Frame& frame : tree.frames()) motions.frames.push_back(frame.name);
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    const Joint& joint = tree.joints[i];
    const std::string joint_frame = implicit_frame_name(joint.name);
    const ElementaryMotion travel = {
        joint.type == JointType::revolute, Axis::z, Quantity::variable(static_cast<int>(i))};
    motions.variables.push_back(variable_name(tree, joint));
    motions.motions.push_back(
        {implicit_frame_name(tree.links[at(joint.parent)].name), joint_frame, steps_of(joint.placement), ""});
    motions.motions.push_back({joint_frame, implicit_frame_name(tree.links[at(joint.child)].name), {travel}, ""});
  }
  for (const UserFrame& frame : tree.user_frames) {
    if (frame.hidden) continue;
    motions.motions.push_back(
        {implicit_frame_name(tree.links[at(frame.link)].name), frame.name, steps_of(frame.placement), ""});
  }
  return motions;
}

}  // namespace robcogen::model
