#include <fmt/format.h>

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

// Those of a document that has a place for them.
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

}  // namespace

void check_drives(const Description& description, Diagnostics& diagnostics) {
  for (const DescribedJoint& joint : description.joints) {
    check_not_negative(joint, "damping", joint.drive.damping, joint.drive_places.damping, diagnostics);
    check_not_negative(joint, "armature", joint.drive.armature, joint.drive_places.armature, diagnostics);
    check_limits(joint, diagnostics);
  }
}

}  // namespace robcogen::model
