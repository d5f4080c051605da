// Rigid-body kinematics in matrices: 4 x 4 poses and 6 x 6 coordinate transforms, angular part first.
#pragma once

#include <complex>

#include "robcogen/reference/matrix.h"

namespace robcogen::reference {

// skew(v) * w = v x w.
template <class Scalar>
Matrix<Scalar> skew(const Vector<Scalar>& v) {
  Matrix<Scalar> m(3, 3);
  m(0, 1) = -v(2);
  m(0, 2) = v(1);
  m(1, 0) = v(2);
  m(1, 2) = -v(0);
  m(2, 0) = -v(1);
  m(2, 1) = v(0);
  return m;
}

// Returns the v for which skew(v) is the antisymmetric part of m.
template <class Scalar>
Vector<Scalar> axis_of(const Matrix<Scalar>& m) {
  const Scalar half = Scalar(1) / Scalar(2);
  return {half * (m(2, 1) - m(1, 2)), half * (m(0, 2) - m(2, 0)), half * (m(1, 0) - m(0, 1))};
}

// The parts of a pose, or of its derivatives.
template <class Scalar>
Matrix<Scalar> rotation_of(const Matrix<Scalar>& pose) {
  return pose.block(0, 0, 3, 3);
}

template <class Scalar>
Vector<Scalar> origin_of(const Matrix<Scalar>& pose) {
  return pose.block(0, 3, 3, 1);
}

// Elementary rotation about coordinate axis 0, 1 or 2 by `angle` (rad).
template <class Scalar>
Matrix<Scalar> rotation(int axis, const Scalar& angle) {
  using std::cos;
  using std::sin;
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  Matrix<Scalar> m = Matrix<Scalar>::identity(4);
  m(i, i) = cos(angle);
  m(i, j) = -sin(angle);
  m(j, i) = sin(angle);
  m(j, j) = cos(angle);
  return m;
}

template <class Scalar>
Matrix<Scalar> translation(const Scalar& x, const Scalar& y, const Scalar& z) {
  Matrix<Scalar> m = Matrix<Scalar>::identity(4);
  m(0, 3) = x;
  m(1, 3) = y;
  m(2, 3) = z;
  return m;
}

// Pose of a frame: translate (m), then rotate about the intrinsic axes x, y', z'' (rad).
template <class Scalar>
Matrix<Scalar> placement(const double (&t)[3], const double (&r)[3]) {
  return translation(Scalar(t[0]), Scalar(t[1]), Scalar(t[2])) * rotation(0, Scalar(r[0])) * rotation(1, Scalar(r[1])) *
         rotation(2, Scalar(r[2]));
}

// Inverse of a pose.
template <class Scalar>
Matrix<Scalar> inverse_of(const Matrix<Scalar>& pose) {
  const Matrix<Scalar> transposed = transpose(rotation_of(pose));
  Matrix<Scalar> m = Matrix<Scalar>::identity(4);
  m.set_block(0, 0, transposed);
  m.set_block(0, 3, -(transposed * origin_of(pose)));
  return m;
}

// Coordinate transform of twists and spatial accelerations, [[R, 0], [p x R, R]].
template <class Scalar>
Matrix<Scalar> motion_form(const Matrix<Scalar>& pose) {
  const Matrix<Scalar> R = rotation_of(pose);
  Matrix<Scalar> m(6, 6);
  m.set_block(0, 0, R);
  m.set_block(3, 0, skew(origin_of(pose)) * R);
  m.set_block(3, 3, R);
  return m;
}

// Coordinate transform of wrenches, [[R, p x R], [0, R]].
template <class Scalar>
Matrix<Scalar> force_form(const Matrix<Scalar>& pose) {
  const Matrix<Scalar> R = rotation_of(pose);
  Matrix<Scalar> m(6, 6);
  m.set_block(0, 0, R);
  m.set_block(0, 3, skew(origin_of(pose)) * R);
  m.set_block(3, 3, R);
  return m;
}

}  // namespace robcogen::reference
