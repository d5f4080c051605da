// Constant poses, for languages with other rotation conventions.
//
// A rotation is stored as the turns by which it was given. Turns that cancel do so exactly, and an angle that remains
// after a change of convention remains the same double. Other angles are computed in long double.
#pragma once

#include <array>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::exporting {

using Real = long double;
using Vector3 = std::array<Real, 3>;
using Matrix3 = std::array<Vector3, 3>;  // row by row

// A rotation about a coordinate axis (0 x, 1 y, 2 z), rad.
struct Turn {
  int axis = 0;
  Number angle;
};

// A pose in a parent frame: a translation, then turns about the axes reached so far, one after the other (R is the
// product of the turns in this order). Consecutive turns have different axes and no angle is zero, so the identity has
// no turns.
struct Pose {
  Vector3 translation{};  // m, in the parent frame
  std::vector<Turn> turns;

  bool is_identity() const { return translation == Vector3{} && turns.empty(); }
};

// The placement must be constant.
Pose pose_of(const model::Placement& placement);
Pose inverse_of(const Pose& pose);
// a_X_c from a_X_b and b_X_c.
Pose operator*(const Pose& a, const Pose& b);

// parent_R_frame. It is exact for turns by multiples of PI/2.
Matrix3 rotation_matrix(const Pose& pose);
Vector3 operator*(const Matrix3& m, const Vector3& v);
Matrix3 operator*(const Matrix3& a, const Matrix3& b);
Matrix3 transpose(const Matrix3& m);

// Roll, pitch and yaw of the rotation R = Rz(yaw) Ry(pitch) Rx(roll), rad. Turns of that form are taken as they are.
// Any others are converted within 1e-15: pitch is then between -PI/2 and PI/2, and roll is zero at these limits; an
// angle that differs from one of the turns by quarter turns only is exactly that.
std::array<double, 3> roll_pitch_yaw(const Pose& pose);

}  // namespace robcogen::exporting
