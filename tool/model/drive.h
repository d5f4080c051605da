// The drive of a joint, which adds terms to the equations of motion, and the limits of the joint.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "model/quantity.h"

namespace robcogen::model {

// The rotor of a motor. It turns in its carrier, which may be any link, with `ratio` times the velocity of the joint.
// The mass properties of the carrier include the rotor as if it were fixed.
struct Rotor {
  Quantity inertia;                                  // kg m^2, about its axis
  Quantity ratio;                                    // rad/rad, rad/m
  std::optional<std::array<Quantity, 3>> axis = {};  // of any length, in axes of the carrier; absent: the joint axis
  int carrier = -1;                                  // link index
};

// In SI units for the joint's type: per rad for revolute joints, per m for prismatic joints. Values that the document
// does not give are zero.
struct Drive {
  Quantity damping;            // N m s, N s/m: force per velocity
  Quantity friction;           // N m, N: Coulomb friction
  Quantity friction_velocity;  // rad/s, m/s: below this speed, friction falls to zero
  Quantity armature;           // kg m^2, kg: inertia that this joint alone accelerates
  Quantity stiffness;          // N m, N/m: spring stiffness
  Quantity rest;               // rad, m: position in which the spring exerts no force
  std::optional<Rotor> rotor = {};

  // Whether there are forces that depend on the joint's own position or velocity.
  bool is_passive() const { return !damping.is_zero() || !friction.is_zero() || !stiffness.is_zero(); }
  bool has_inertia() const { return !armature.is_zero() || rotor.has_value(); }
  bool is_absent() const { return !is_passive() && !has_inertia(); }
  // Tells which values are not zero. These are the same for congruent limbs.
  std::vector<bool> present(bool with_passive_forces) const {
    std::vector<bool> flags = {rotor.has_value(), rotor && rotor->axis};
    flags.push_back(!armature.is_zero());
    if (!with_passive_forces) return flags;
    for (const Quantity* q : {&damping, &friction, &friction_velocity, &stiffness, &rest})
      flags.push_back(!q->is_zero());
    return flags;
  }
};

// Limits of position (rad or m), velocity (rad/s or m/s) and effort (N m or N). No generated function uses them.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();
  double effort = std::numeric_limits<double>::infinity();
  friend bool operator==(const JointLimits&, const JointLimits&) = default;
};

// Stands for no limit where a document must give a number, in SI units; no joint comes near it.
inline constexpr double kNoLimit = 1e9;

// Returns an infinite limit for a number that stands for none.
double bounded(double limit);

}  // namespace robcogen::model
