#include "model/spherical_joints.h"

#include <algorithm>
#include <utility>

#include "support/index.h"

namespace robcogen::model {
namespace {

constexpr int kComponents = 3;

// Adds a joint from one link to another.
void connect(KinematicTree& tree, Joint joint, int parent, int child) {
  joint.parent = parent;
  joint.child = child;
  tree.links[at(child)].parent_joint = static_cast<int>(tree.joints.size());
  tree.joints.push_back(std::move(joint));
}

void add_components(KinematicTree& tree, const Joint& joint) {
  int parent = joint.parent;
  for (int axis = 0; axis < kComponents; ++axis) {
    Joint component = joint;
    component.name = joint.name + kQuaternionSuffixes[at(1 + axis)];
    component.spherical = joint.name;
    component.axis = axis;
    if (axis > 0) component.placement = {};
    int child = joint.child;
    if (axis + 1 < kComponents) {
      child = static_cast<int>(tree.links.size());
      const Link& carried = tree.links[at(joint.child)];
      Link between = {carried.name, {}, -1, {static_cast<int>(tree.joints.size()) + 1}, carried.place};
      between.is_repeated = true;
      tree.links.push_back(std::move(between));
    }
    connect(tree, std::move(component), parent, child);
    parent = child;
  }
}

}  // namespace

void expand_spherical_joints(KinematicTree& tree) {
  const auto is_spherical = [](const Joint& joint) { return joint.type == JointType::spherical; };
  if (std::none_of(tree.joints.begin(), tree.joints.end(), is_spherical)) return;
  const std::vector<Joint> before = std::exchange(tree.joints, {});
  std::vector<int> moved;  // by joint: its new index, or that of its first component
  int place = 0;
  for (const Joint& joint : before) {
    moved.push_back(place);
    place += is_spherical(joint) ? kComponents : 1;
  }
  for (Link& link : tree.links)
    for (int& child : link.child_joints) child = moved[at(child)];
  for (const Joint& joint : before) {
    if (is_spherical(joint))
      add_components(tree, joint);
    else
      connect(tree, joint, joint.parent, joint.child);
  }
  for (Coupling& coupling : tree.couplings) {
    coupling.joint = moved[at(coupling.joint)];
    for (Coupling::Term& term : coupling.terms) term.joint = moved[at(term.joint)];
  }
  for (Tendon& tendon : tree.tendons)
    for (Tendon::Term& term : tendon.terms) term.joint = moved[at(term.joint)];
  for (LoopJoint& loop : tree.loops)
    for (LoopEnd& end : loop.ends)
      for (int& joint : end.joints) joint = moved[at(joint)];
  for (std::vector<Closure>* closures : {&tree.closures, &tree.parallelograms})
    for (Closure& closure : *closures)
      for (int& joint : closure.dependents) joint = moved[at(joint)];
  for (Limb& limb : tree.limbs) {
    const std::vector<Limb::Element> joints = std::exchange(limb.joints, {});
    for (const Limb::Element& joint : joints) {
      const bool has_components = is_spherical(before[at(joint.index)]);
      for (int axis = 0; axis < (has_components ? kComponents : 1); ++axis)
        limb.joints.push_back(
            {joint.own + (has_components ? kQuaternionSuffixes[at(1 + axis)] : ""), moved[at(joint.index)] + axis});
    }
  }
}

}  // namespace robcogen::model
