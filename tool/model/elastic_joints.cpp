#include "model/elastic_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace robcogen::model {
namespace {

// The entry of the joint among the children of the links; nullptr if no link names it, which `build` reports. Appending
// to `description.links` invalidates it.
DescribedLink* parent_of(Description& description, const std::string& joint) {
  const auto names_joint = [&](const DescribedLink& link) {
    return std::any_of(
        link.children.begin(), link.children.end(), [&](const DescribedChild& child) { return child.joint == joint; });
  };
  if (names_joint(description.base)) return &description.base;
  const auto found = std::find_if(description.links.begin(), description.links.end(), names_joint);
  return found == description.links.end() ? nullptr : &*found;
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
  for (std::size_t j = 0, count = description.joints.size(); j < count; ++j) {
    DescribedJoint& joint = description.joints[j];
    if (!joint.elasticity) continue;
    if (!may_have_motor(joint, diagnostics)) continue;
    DescribedLink* parent = parent_of(description, joint.name);
    if (parent == nullptr) continue;
    const DescribedElasticity spring = *std::exchange(joint.elasticity, std::nullopt);
    DescribedJoint motor = motor_of(joint);
    // The axis of a rotor on the joint's child is that of the joint, as it is for a joint without a spring.
    const auto child = std::find_if(
        parent->children.begin(), parent->children.end(), [&](const auto& c) { return c.joint == joint.name; });
    if (motor.drive.rotor && !motor.drive.rotor->axis && motor.rotor_carrier == child->link)
      motor.drive.rotor->axis = {Quantity(), Quantity(), Quantity(1.0)};
    DescribedLink link;
    link.name = motor_link_name(joint.name);
    link.place = joint.place;
    link.is_virtual = true;
    parent->children.push_back({link.name, motor.name, joint.place, joint.place});
    DescribedTendon tendon = {
        elasticity_name(joint.name), spring.place, {}, spring.stiffness, spring.damping, Quantity()};
    tendon.stiffness_place = spring.stiffness_place;
    tendon.damping_place = spring.damping_place;
    tendon.terms = {{motor.name, Quantity(1.0), spring.place}, {joint.name, Quantity(-1.0), spring.place}};
    description.tendons.push_back(std::move(tendon));
    description.links.push_back(std::move(link));
    description.joints.push_back(std::move(motor));
  }
}

}  // namespace robcogen::model
