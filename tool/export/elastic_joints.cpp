#include "export/elastic_joints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "model/elastic_joints.h"
#include "support/index.h"

namespace robcogen::exporting {

namespace kinematics = language::kinematics;
using model::Joint;
using model::KinematicTree;
using model::Quantity;
using model::Tendon;

namespace {

bool are_same(const model::Placement& a, const model::Placement& b) {
  return a.translation == b.translation && a.rotation == b.rotation;
}

// Whether the tendon has the length motor - joint.
bool connects(const KinematicTree& tree, const Tendon& tendon, int joint, int motor) {
  const auto has = [&](int j, double factor) {
    return std::any_of(tendon.terms.begin(), tendon.terms.end(), [&](const Tendon::Term& term) {
      return term.joint == j && term.factor == Quantity(factor);
    });
  };
  return tendon.terms.size() == 2 && has(joint, -1.0) && has(motor, 1.0) && tendon.rest.is_zero() &&
         !tendon.stiffness.is_zero() && tendon.name == model::elasticity_name(tree.joints[at(joint)].name);
}

// The only tendon of the motor, if it is its spring.
std::optional<int> spring_of(const KinematicTree& tree, int joint, int motor) {
  std::optional<int> spring;
  for (std::size_t t = 0; t < tree.tendons.size(); ++t) {
    const auto& terms = tree.tendons[t].terms;
    if (std::none_of(terms.begin(), terms.end(), [&](const Tendon::Term& term) { return term.joint == motor; }))
      continue;
    if (spring || !connects(tree, tree.tendons[t], joint, motor)) return std::nullopt;
    spring = static_cast<int>(t);
  }
  return spring;
}

// Whether the motor has only what reading moves to it from its joint.
bool is_plain_motor(const KinematicTree& tree, const Joint& joint, int index) {
  const Joint& motor = tree.joints[at(index)];
  const model::Link& link = tree.links[at(motor.child)];
  const bool is_of_link = std::any_of(
      tree.user_frames.begin(), tree.user_frames.end(), [&](const auto& frame) { return frame.link == motor.child; });
  const bool is_bare = !link.inertia && link.child_joints.empty() && !is_of_link && link.is_virtual &&
                       link.name == model::motor_link_name(joint.name) && motor.name == model::motor_name(joint.name);
  const bool has_limits = std::isfinite(motor.limits.lower) || std::isfinite(motor.limits.upper) ||
                          std::isfinite(motor.limits.velocity) || std::isfinite(joint.limits.effort);
  const auto kind =
      joint.type == model::JointType::prismatic ? model::JointType::prismatic : model::JointType::revolute;
  const auto is_term = [&](const auto& coupling) {
    return coupling.joint == index || std::any_of(coupling.terms.begin(), coupling.terms.end(), [&](const auto& term) {
             return term.joint == index;
           });
  };
  return is_bare && !has_limits && !motor.drive.is_passive() && motor.drive.has_inertia() &&
         !joint.drive.has_inertia() && motor.type == kind && motor.parent == joint.parent &&
         are_same(motor.placement, joint.placement) &&
         std::none_of(tree.couplings.begin(), tree.couplings.end(), is_term);
}

}  // namespace

std::vector<ElasticJoint> elastic_joints(const KinematicTree& tree) {
  std::vector<ElasticJoint> result;
  for (int motor = 0; motor < static_cast<int>(tree.joints.size()); ++motor) {
    const std::string& name = tree.joints[at(motor)].motor_of;
    const std::optional<int> joint = name.empty() ? std::nullopt : tree.find_joint(name);
    if (!joint || !is_plain_motor(tree, tree.joints[at(*joint)], motor)) continue;
    if (const std::optional<int> tendon = spring_of(tree, *joint, motor)) result.push_back({*joint, motor, *tendon});
  }
  const auto first = tree.joints.size() - result.size();
  for (std::size_t k = 0; k < result.size(); ++k) {
    const bool is_in_order = k == 0 || result[k - 1].joint < result[k].joint;
    if (result[k].motor != static_cast<int>(first + k) || !is_in_order) return {};
  }
  return result;
}

kinematics::Document with_elastic_joints(const KinematicTree& tree, kinematics::Document document) {
  const auto named = [](const std::string& name) { return [&name](const auto& e) { return e.name.text == name; }; };
  for (const ElasticJoint& elastic : elastic_joints(tree)) {
    const std::string& joint = tree.joints[at(elastic.joint)].name;
    const Joint& motor = tree.joints[at(elastic.motor)];
    const std::string& link = tree.links[at(motor.child)].name;
    const auto from = std::find_if(document.joints.begin(), document.joints.end(), named(motor.name));
    const auto to = std::find_if(document.joints.begin(), document.joints.end(), named(joint));
    const auto spring =
        std::find_if(document.tendons.begin(), document.tendons.end(), named(tree.tendons[at(elastic.tendon)].name));
    to->drive.armature = from->drive.armature;
    to->rotor = from->rotor;
    to->limits.effort = from->limits.effort;
    to->elasticity = kinematics::Elasticity{spring->stiffness, spring->damping, {}};
    document.joints.erase(from);
    document.tendons.erase(spring);
    std::erase_if(document.links, named(link));
    for (kinematics::Link& parent : document.links)
      std::erase_if(parent.children, [&](const kinematics::Child& child) { return child.link.text == link; });
  }
  return document;
}

KinematicTree with_rigid_joints(const KinematicTree& tree) {
  KinematicTree rigid = tree;
  const std::vector<ElasticJoint> elastic = elastic_joints(tree);
  for (auto e = elastic.rbegin(); e != elastic.rend(); ++e) {
    const Joint motor = rigid.joints[at(e->motor)];
    rigid.joints[at(e->joint)].limits.effort = motor.limits.effort;
    rigid.joints.pop_back();
    rigid.links.erase(rigid.links.begin() + motor.child);
    const auto moved = [&](int& link) { link -= link > motor.child ? 1 : 0; };
    for (Joint& joint : rigid.joints) {
      moved(joint.parent);
      moved(joint.child);
      if (joint.drive.rotor) moved(joint.drive.rotor->carrier);
    }
    for (model::Link& link : rigid.links) std::erase(link.child_joints, e->motor);
    for (model::UserFrame& frame : rigid.user_frames) moved(frame.link);
    for (model::LoopJoint& loop : rigid.loops)
      for (model::LoopEnd& end : loop.ends) moved(end.link);
  }
  std::erase_if(rigid.tendons, [&](const Tendon& tendon) {
    return std::any_of(
        elastic.begin(), elastic.end(), [&](const auto& e) { return tree.tendons[at(e.tendon)].name == tendon.name; });
  });
  return rigid;
}

}  // namespace robcogen::exporting
