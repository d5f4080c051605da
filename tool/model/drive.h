// What the drive of a joint adds to the equations of motion, and the limits of the joint.
#pragma once

#include <limits>
#include <vector>

#include "model/quantity.h"

namespace robcogen::model {

// In SI units for the joint's type: per rad for revolute joints, per m for prismatic ones. All are zero where a
// document does not say otherwise.
struct Drive {
  Quantity damping;   // N m s, N s/m: force per velocity
  Quantity armature;  // kg m^2, kg: inertia that this joint alone accelerates

  // Whether forces depend on the joint's own position or velocity.
  bool is_passive() const { return !damping.is_zero(); }
  bool has_inertia() const { return !armature.is_zero(); }
  bool is_absent() const { return !is_passive() && !has_inertia(); }
  // Which of the values are not zero: congruent limbs have the same ones.
  std::vector<bool> present() const { return {!damping.is_zero(), !armature.is_zero()}; }
};

// Limits of position (rad or m), velocity (per second) and effort (N m or N). No function computes with them.
struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();
  double effort = std::numeric_limits<double>::infinity();
  friend bool operator==(const JointLimits&, const JointLimits&) = default;
};

}  // namespace robcogen::model
