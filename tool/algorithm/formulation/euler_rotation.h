// The rotation of a joint as Rz(a) Rx(b) Rz(c), where c includes the position of a joint that turns. Every rotation has
// this form, so rotations of congruent limbs can have it in common that are written in different ways: with other axes,
// or with other quarter turns.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algorithm/spatial/rotation.h"
#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

// One of the three rotations: quarter turns if all limbs have quarter turns there, otherwise a plane rotation.
struct EulerTurn {
  int axis = 2;
  bool is_quarters = false;
  double angle = 0.0;             // rad, of this limb
  double c = 1.0, s = 0.0;        // the representative numbers of the plane rotation, or
  double angle_with_joint = 0.0;  // that of the constant which is added to a joint's position
};
using EulerRotation = std::array<EulerTurn, 3>;

// The constant angle of a sum, and the rest.
struct AngleParts {
  double constant = 0.0;
  Expression rest;
};
AngleParts parts_of_angle(const Expression& angle);

// The constant parts of the three angles; nullopt if other planes than the last one, about z, are not constant.
std::optional<std::array<double, 3>> euler_angles(const Rotation& rotation);

// Whether an angle is a multiple of 90 degrees up to the rounding of these functions.
bool is_multiple_of_quarter(double angle);

// The rotation in this form.
Rotation as_euler_rotation(Trace& trace, const EulerRotation& turns, const Rotation& rotation);

}  // namespace robcogen::algorithm
