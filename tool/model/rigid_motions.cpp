#include "model/rigid_motions.h"

#include <algorithm>
#include <utility>

#include "support/index.h"

namespace robcogen::model {

namespace {

// The steps trx try trz rotx roty rotz; steps of zero are omitted.
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

// Returns a name that no parameter has.
std::string variable_name(const KinematicTree& tree, const std::string& joint) {
  std::string name = "q_" + joint;
  const auto is_taken = [&] {
    return std::any_of(
        tree.parameters.begin(), tree.parameters.end(), [&](const Parameter& p) { return p.name == name; });
  };
  while (is_taken()) name += "_";
  return name;
}

// The motion of a joint at this position.
std::vector<ElementaryMotion> travel_of(const Joint& joint, const Quantity& position) {
  std::vector<ElementaryMotion> steps;
  if (turns(joint.type)) steps.push_back({true, Axis::z, position});
  const Quantity slide = slide_of(joint) * position;
  if (!slide.is_zero()) steps.push_back({false, Axis::z, slide});
  return steps;
}

// `positions` are the positions of the joints, over the variables of these names.
RigidMotions motions_of(
    const KinematicTree& tree,
    const std::vector<Quantity>& positions,
    std::vector<std::string> variables) {
  RigidMotions motions;
  motions.name = tree.name;
  motions.convention = MotionConvention::local;
  motions.parameters = tree.parameters;
  motions.variables = std::move(variables);
  for (const Frame& frame : tree.frames()) motions.frames.push_back(frame.name);
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    const Joint& joint = tree.joints[i];
    if (!joint.is_first()) continue;
    const std::string joint_frame = implicit_frame_name(joint.declared_name());
    const std::vector<ElementaryMotion> travel = joint.spherical.empty()
                                                     ? travel_of(joint, positions[i])
                                                     : std::vector{spherical_motion(tree, static_cast<int>(i))};
    motions.motions.push_back(
        {implicit_frame_name(tree.links[at(joint.parent)].name), joint_frame, steps_of(joint.placement), ""});
    motions.motions.push_back({joint_frame, implicit_frame_name(tree.links[at(joint.child)].name), travel, ""});
  }
  for (const UserFrame& frame : tree.user_frames) {
    if (frame.hidden) continue;
    motions.motions.push_back(
        {implicit_frame_name(tree.links[at(frame.link)].name), frame.name, steps_of(frame.placement), ""});
  }
  return motions;
}

}  // namespace

ElementaryMotion spherical_motion(const KinematicTree& tree, int joint) {
  const std::vector<int> all = tree.spherical_joints();
  const auto number = static_cast<int>(std::find(all.begin(), all.end(), joint) - all.begin());
  const auto element = [](int index) { return Quantity::variable(index); };
  const Quantity scalar = element(static_cast<int>(tree.joints.size()) + number);
  return {true, Axis::z, {}, {scalar, element(joint), element(joint + 1), element(joint + 2)}};
}

RigidMotions motions_of(const KinematicTree& tree) {
  std::vector<Quantity> positions;
  std::vector<std::string> names;
  for (const Joint& joint : tree.joints) {
    positions.push_back(Quantity::variable(static_cast<int>(names.size())));
    names.push_back(variable_name(tree, joint.name));
  }
  for (const int joint : tree.spherical_joints())
    names.push_back(variable_name(tree, tree.joints[at(joint)].spherical + kQuaternionSuffixes[0]));
  return motions_of(tree, positions, std::move(names));
}

RigidMotions motions_over_coordinates(const KinematicTree& tree) {
  std::vector<Quantity> positions(tree.joints.size());  // by joint
  std::vector<std::string> names;
  for (const int joint : tree.coordinates()) {
    positions[at(joint)] = Quantity::variable(static_cast<int>(names.size()));
    names.push_back(variable_name(tree, tree.joints[at(joint)].name));
  }
  for (const Coupling& coupling : tree.couplings) {
    Quantity& position = positions[at(coupling.joint)];
    for (const Coupling::Term& term : coupling.terms) position = position + term.factor * positions[at(term.joint)];
    position = position + coupling.offset;
  }
  return motions_of(tree, positions, std::move(names));
}

}  // namespace robcogen::model
