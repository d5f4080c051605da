#include <fmt/format.h>

#include <algorithm>

#include "model/plausibility.h"

namespace robcogen::model {
namespace {

void check_not_negative(
    const DescribedJoint& joint,
    const char* what,
    const Quantity& value,
    const Place& place,
    Diagnostics& diagnostics) {
  if (!value.is_constant() || !(value.number().value() < 0.0)) return;
  diagnostics.error(
      "negative-drive", place,
      fmt::format("the {} of joint '{}' is negative: {}", what, joint.name, print_double(value.number().value())));
}

void check_rotor(const DescribedJoint& joint, const Rotor& rotor, Diagnostics& diagnostics) {
  const DrivePlaces& places = joint.drive_places;
  check_not_negative(joint, "inertia of the rotor", rotor.inertia, places.rotor_inertia, diagnostics);
  if (rotor.ratio.is_zero())
    diagnostics.error(
        "rotor-ratio-zero", places.rotor_ratio,
        fmt::format("the ratio of the rotor of joint '{}' is zero: the joint would not turn it", joint.name));
  const auto is_zero = [](const Quantity& q) { return q.is_zero(); };
  if (rotor.axis && std::all_of(rotor.axis->begin(), rotor.axis->end(), is_zero))
    diagnostics.error(
        "rotor-axis-zero", places.rotor_axis,
        fmt::format("the axis of the rotor of joint '{}' has no direction: all its components are zero", joint.name));
}

// Checks limits that the document states.
void check_limits(const DescribedJoint& joint, Diagnostics& diagnostics) {
  const JointLimits& limits = joint.limits;
  const DrivePlaces& places = joint.drive_places;
  if (places.position_limits.source && limits.lower > limits.upper)
    diagnostics.error(
        "limits-order", places.position_limits,
        fmt::format(
            "the lower limit {} of joint '{}' is above the upper limit {}", print_double(limits.lower), joint.name,
            print_double(limits.upper)));
  if (places.velocity_limit.source)
    check_not_negative(joint, "velocity limit", Quantity(limits.velocity), places.velocity_limit, diagnostics);
  if (places.effort_limit.source)
    check_not_negative(joint, "effort limit", Quantity(limits.effort), places.effort_limit, diagnostics);
}

// Refuses what needs an axis or a scalar position.
void check_spherical(const DescribedJoint& joint, Diagnostics& diagnostics) {
  const DrivePlaces& places = joint.drive_places;
  const auto refuse = [&](const char* what, const Place& place) {
    if (!place.source) return;
    diagnostics
        .error(
            "spherical-joint-drive", place,
            fmt::format("spherical joint '{}' cannot have {}: it has no axis", joint.name, what))
        .hint = "it can have damping, armature, and limits of velocity and effort, equal about all axes";
  };
  refuse("friction", places.friction);
  refuse("a spring", places.stiffness);
  refuse("a rotor", places.rotor);
  refuse("limits of position", places.position_limits);
  refuse("an 'assembled' position", joint.assembled_place);
}

}  // namespace

void check_drives(const Description& description, Diagnostics& diagnostics) {
  for (const DescribedJoint& joint : description.joints) {
    const Drive& drive = joint.drive;
    const DrivePlaces& places = joint.drive_places;
    check_not_negative(joint, "damping", drive.damping, places.damping, diagnostics);
    check_not_negative(joint, "friction", drive.friction, places.friction, diagnostics);
    check_not_negative(
        joint, "velocity of the friction", drive.friction_velocity, places.friction_velocity, diagnostics);
    check_not_negative(joint, "armature", drive.armature, places.armature, diagnostics);
    check_not_negative(joint, "stiffness of the spring", drive.stiffness, places.stiffness, diagnostics);
    if (drive.rotor) check_rotor(joint, *drive.rotor, diagnostics);
    if (joint.type == JointType::spherical) check_spherical(joint, diagnostics);
    check_limits(joint, diagnostics);
  }
}

}  // namespace robcogen::model
