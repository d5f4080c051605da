// Rotations and poses that stay exact when their angles are.
#pragma once

#include <array>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::import {

// About a coordinate axis, by an angle in radians.
struct Turn {
  int axis = 0;
  Number angle;
};

// A product of turns, the first one leftmost, and of quarter turns, which are exact and kept separately: they commute
// with other turns by changing their axes. Two neighbours in `turns` have different axes, and none is a quarter turn.
struct Rotation {
  std::vector<Turn> turns;
  std::array<std::array<int, 3>, 3> quarter_turns = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // a signed permutation
};

Rotation rotation_about(int axis, const Number& angle);
// R = Rz(yaw) Ry(pitch) Rx(roll), as in a URDF.
Rotation rotation_of_rpy(const std::array<Number, 3>& roll_pitch_yaw);
// The rotation A = Rx(a) Ry(b) such that A e_z has the direction of the axis, which is not zero. Its angles are exact
// for coordinate axes and for the bisectors of two of them; it is the identity for e_z.
Rotation rotation_to_axis(const std::array<Number, 3>& axis);
Rotation operator*(const Rotation& a, const Rotation& b);
Rotation inverse(const Rotation& rotation);

// The angles of R = Rx Ry Rz. An angle that equals one of the turns, up to quarter turns, is exact. A multiple of PI
// follows only from multiples of PI, except that a difference of rounding from zero is zero. When Rx and Rz turn about
// one axis, Rz is zero.
std::array<Number, 3> intrinsic_angles(const Rotation& rotation);

struct Pose {
  std::array<model::Quantity, 3> translation;
  Rotation rotation;
};

Pose operator*(const Pose& a, const Pose& b);
model::Placement placement_of(const Pose& pose);

}  // namespace robcogen::import
