#include "model/elastic_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace robcogen::model {
namespace {

// By joint: the index of its parent as in described_link, and its child. Joints that no link names are reported by
// `build`.
struct Links {
  std::size_t parent = 0;
  std::string child;
};
std::map<std::string, Links> links_of_joints(const Description& description) {
  std::map<std::string, Links> result;
  for (std::size_t l = 0; l <= description.links.size(); ++l)
    for (const DescribedChild& child : described_link(description, l).children)
      result.insert({child.joint, {l, child.link}});
  return result;
}

// Whether the joint can have a motor; reports why not.
bool may_have_motor(const DescribedJoint& joint, Diagnostics& diagnostics) {
  if (joint.type == JointType::spherical) {
    diagnostics
        .error(
            "spherical-joint-drive", joint.elasticity->place,
            fmt::format("spherical joint '{}' cannot be elastic: it has no axis", joint.name))
        .hint = "three revolute joints in a row can be elastic";
    return false;
  }
  if (joint.elasticity->stiffness.is_zero()) {
    diagnostics.error(
        "elastic-without-stiffness", joint.elasticity->stiffness_place,
        fmt::format("the stiffness of elastic joint '{}' is zero: its motor would not move it", joint.name));
    return false;
  }
  if (joint.drive.has_inertia()) return true;
  diagnostics
      .error(
          "elastic-without-inertia", joint.elasticity->place,
          fmt::format("elastic joint '{}' has no 'armature': its motor would move without inertia", joint.name))
      .hint = "give it an armature: the inertia of the rotor times the square of the gear ratio";
  return false;
}

// By name: where the links and joints are declared.
std::map<std::string, Place> places_of_names(const Description& description) {
  std::map<std::string, Place> places = {{description.base.name, description.base.place}};
  for (const DescribedLink& link : description.links) places.insert({link.name, link.place});
  for (const DescribedJoint& joint : description.joints) places.insert({joint.name, joint.place});
  return places;
}

// Whether the names for the motor of the joint are free; reports one that is not.
bool are_names_free(const DescribedJoint& joint, const std::map<std::string, Place>& taken, Diagnostics& diagnostics) {
  for (const std::string& name : {motor_name(joint.name), motor_link_name(joint.name)}) {
    const auto other = taken.find(name);
    if (other == taken.end()) continue;
    diagnostics
        .error(
            "motor-name-clash", other->second,
            fmt::format("'{}' is the name of the motor of elastic joint '{}', or of its link", name, joint.name))
        .notes.push_back({joint.place, "the elastic joint is declared here"});
    return false;
  }
  return true;
}

DescribedJoint motor_of(DescribedJoint& joint) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  DescribedJoint motor;
  motor.name = motor_name(joint.name);
  motor.place = joint.place;
  motor.motor_of = joint.name;
  // A screw's motor turns, too.
  motor.type = joint.type == JointType::prismatic ? JointType::prismatic : JointType::revolute;
  motor.placement = joint.placement;
  motor.limits.effort = std::exchange(joint.limits.effort, kUnlimited);
  motor.drive.armature = std::exchange(joint.drive.armature, Quantity());
  motor.drive.rotor = std::exchange(joint.drive.rotor, std::nullopt);
  motor.rotor_carrier = std::exchange(joint.rotor_carrier, std::nullopt);
  DrivePlaces &from = joint.drive_places, &to = motor.drive_places;
  for (Place DrivePlaces::*place :
       {&DrivePlaces::armature, &DrivePlaces::rotor, &DrivePlaces::rotor_inertia, &DrivePlaces::rotor_ratio,
        &DrivePlaces::rotor_axis, &DrivePlaces::rotor_carrier, &DrivePlaces::effort_limit})
    to.*place = std::exchange(from.*place, Place());
  return motor;
}

}  // namespace

std::string motor_name(const std::string& joint) {
  return joint + "_motor";
}

std::string motor_link_name(const std::string& joint) {
  return joint + "_motor_link";
}

std::string elasticity_name(const std::string& joint) {
  return joint + "_elastic";
}

void add_motors(Description& description, Diagnostics& diagnostics) {
  const auto is_elastic = [](const DescribedJoint& joint) { return joint.elasticity.has_value(); };
  if (std::none_of(description.joints.begin(), description.joints.end(), is_elastic)) return;
  const std::map<std::string, Place> taken = places_of_names(description);
  const std::map<std::string, Links> links = links_of_joints(description);
  for (std::size_t j = 0, count = description.joints.size(); j < count; ++j) {
    DescribedJoint& joint = description.joints[j];
    if (!joint.elasticity || !may_have_motor(joint, diagnostics) || !are_names_free(joint, taken, diagnostics))
      continue;
    const auto connected = links.find(joint.name);
    if (connected == links.end()) continue;
    const auto& [parent, child] = connected->second;
    const DescribedElasticity spring = *std::exchange(joint.elasticity, std::nullopt);
    DescribedJoint motor = motor_of(joint);
    // The axis of a rotor on the joint's child is that of the joint, as it is for a joint without a spring.
    if (motor.drive.rotor && !motor.drive.rotor->axis && motor.rotor_carrier == child)
      motor.drive.rotor->axis = {Quantity(), Quantity(), Quantity(1.0)};
    DescribedLink link;
    link.name = motor_link_name(joint.name);
    link.place = joint.place;
    link.is_virtual = true;
    (parent == 0 ? description.base : description.links[parent - 1])
        .children.push_back({link.name, motor.name, joint.place, joint.place});
    DescribedTendon tendon = {
        elasticity_name(joint.name), spring.place, {}, spring.stiffness, spring.damping, Quantity()};
    tendon.stiffness_place = spring.stiffness_place;
    tendon.damping_place = spring.damping_place;
    tendon.terms = {{motor.name, Quantity(1.0), spring.place}, {joint.name, Quantity(-1.0), spring.place}};
    description.tendons.push_back(std::move(tendon));
    description.driven.push_back(joint.name);
    description.links.push_back(std::move(link));
    description.joints.push_back(std::move(motor));
  }
}

}  // namespace robcogen::model
