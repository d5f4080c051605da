// Rotations and poses that stay exact where their angles are.
#pragma once

#include <array>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::import::from_urdf {

// About a coordinate axis, by an angle in radians.
struct Turn {
  int axis = 0;
  Number angle;
};

// A product of turns, first one leftmost, and then quarter turns, which are exact and are kept apart: they pass through
// other turns by changing their axes. No two neighbours among `turns` are about one axis, none is a quarter turn.
struct Rotation {
  std::vector<Turn> turns;
  std::array<std::array<int, 3>, 3> quarter_turns = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // a signed permutation
};

Rotation rotation_about(int axis, const Number& angle);
// R = Rz(yaw) Ry(pitch) Rx(roll), as in a URDF.
Rotation rotation_of_rpy(const std::array<Number, 3>& roll_pitch_yaw);
// The rotation A = Rx(a) Ry(b) for which A e_z is the direction of the axis, which is not zero. Its angles are exact
// for coordinate axes and for halves between two of them; the identity for e_z.
Rotation rotation_to_axis(const std::array<Number, 3>& axis);
Rotation operator*(const Rotation& a, const Rotation& b);
Rotation inverse(const Rotation& rotation);

// The angles of R = Rx Ry Rz. An angle that is one of the rotation's turns, or that and quarter turns, is exactly that.
// A multiple of PI comes of multiples of PI only, but that what differs from zero by rounding is zero. Where Rx and Rz
// turn about one axis, Rz is zero.
std::array<Number, 3> intrinsic_angles(const Rotation& rotation);

struct Pose {
  std::array<model::Quantity, 3> translation;
  Rotation rotation;
};

Pose operator*(const Pose& a, const Pose& b);
model::Placement placement_of(const Pose& pose);

}  // namespace robcogen::import::from_urdf
