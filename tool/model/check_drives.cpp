#include <fmt/format.h>

#include <algorithm>

#include "model/plausibility.h"

namespace robcogen::model {
namespace {

// Reports negative values of a joint.
class SignCheck {
 public:
  SignCheck(const DescribedJoint& joint, const std::vector<Parameter>& parameters, Diagnostics& diagnostics)
      : joint_(joint), parameters_(parameters), diagnostics_(diagnostics) {}

  void operator()(const char* what, const Quantity& quantity, const Place& place) const {
    const double value = value_at_defaults(quantity, parameters_).value_or(0.0);
    if (!(value < 0.0)) return;
    diagnostics_.error(
        "negative-drive", place,
        fmt::format(
            "the {} of joint '{}' is negative{}: {}", what, joint_.name,
            quantity.is_constant() ? "" : " by the default values of parameters", print_double(value)));
  }

 private:
  const DescribedJoint& joint_;
  const std::vector<Parameter>& parameters_;
  Diagnostics& diagnostics_;
};

void check_rotor(const DescribedJoint& joint, const Rotor& rotor, const SignCheck& sign, Diagnostics& diagnostics) {
  const DrivePlaces& places = joint.drive_places;
  sign("inertia of the rotor", rotor.inertia, places.rotor_inertia);
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
void check_limits(const DescribedJoint& joint, const SignCheck& sign, Diagnostics& diagnostics) {
  const JointLimits& limits = joint.limits;
  const DrivePlaces& places = joint.drive_places;
  if (places.position_limits.source && limits.lower > limits.upper)
    diagnostics.error(
        "limits-order", places.position_limits,
        fmt::format(
            "the lower limit {} of joint '{}' is above the upper limit {}", print_double(limits.lower), joint.name,
            print_double(limits.upper)));
  if (places.velocity_limit.source) sign("velocity limit", Quantity(limits.velocity), places.velocity_limit);
  if (places.effort_limit.source) sign("effort limit", Quantity(limits.effort), places.effort_limit);
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
    const SignCheck sign(joint, description.parameters, diagnostics);
    sign("damping", drive.damping, places.damping);
    sign("friction", drive.friction, places.friction);
    sign("velocity of the friction", drive.friction_velocity, places.friction_velocity);
    sign("armature", drive.armature, places.armature);
    sign("stiffness of the spring", drive.stiffness, places.stiffness);
    if (drive.rotor) check_rotor(joint, *drive.rotor, sign, diagnostics);
    if (joint.type == JointType::spherical) check_spherical(joint, diagnostics);
    check_limits(joint, sign, diagnostics);
  }
}

}  // namespace robcogen::model
