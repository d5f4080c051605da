// Rotations and poses that stay exact if their angles are exact.
#pragma once

#include <array>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::import {

// A rotation about a coordinate axis (0, 1 or 2) by an angle in radians.
struct Turn {
  int axis = 0;
  Number angle;
};

// A product of turns, from left to right, and of quarter turns, which are exact and kept separately: they commute with
// other turns by changing their axes. Two adjacent elements of `turns` have different axes, and none is a quarter turn.
struct Rotation {
  std::vector<Turn> turns;
  std::array<std::array<int, 3>, 3> quarter_turns = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // a signed permutation
};

Rotation rotation_about(int axis, const Number& angle);
// R = Rz(yaw) Ry(pitch) Rx(roll), as in a URDF.
Rotation rotation_of_rpy(const std::array<Number, 3>& roll_pitch_yaw);
// Returns the rotation A = Rx(a) Ry(b) such that A e_z has the direction of the axis, which must not be zero. Its
// angles are exact for coordinate axes and for the bisectors of two of them; it is the identity for e_z.
Rotation rotation_to_axis(const std::array<Number, 3>& axis);
Rotation operator*(const Rotation& a, const Rotation& b);
Rotation inverse(const Rotation& rotation);

// Returns the angles of R = Rx Ry Rz. An angle that equals one of the turns, up to quarter turns, is exact. A multiple
// of PI results only from multiples of PI, except that a rounding difference from zero counts as zero. If Rx and Rz
// turn about the same axis, Rz is zero.
std::array<Number, 3> intrinsic_angles(const Rotation& rotation);

struct Pose {
  std::array<model::Quantity, 3> translation;
  Rotation rotation;
};

Pose operator*(const Pose& a, const Pose& b);
Pose inverse(const Pose& pose);
model::Placement placement_of(const Pose& pose);

}  // namespace robcogen::import
