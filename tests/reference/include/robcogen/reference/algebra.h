// Matrices of rigid-body kinematics, spelled out in full: 4 x 4 poses and 6 x 6 spatial transforms.
//
// Nothing here is meant to be fast. The scalar may be real (double, long double) or, for poses, complex.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <complex>

namespace robcogen::reference {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Vector6 = Eigen::Matrix<Scalar, 6, 1>;  // angular first
template <class Scalar>
using VectorX = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using Matrix4 = Eigen::Matrix<Scalar, 4, 4>;
template <class Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;
template <class Scalar>
using Matrix6X = Eigen::Matrix<Scalar, 6, Eigen::Dynamic>;
template <class Scalar>
using MatrixX = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

// skew(v) * w = v x w.
template <class Scalar>
Matrix3<Scalar> skew(const Vector3<Scalar>& v) {
  const Scalar o(0);
  Matrix3<Scalar> m;
  m << o, -v(2), v(1),  //
      v(2), o, -v(0),   //
      -v(1), v(0), o;
  return m;
}

// The v of which skew(v) is the antisymmetric part of m.
template <class Scalar>
Vector3<Scalar> axis_of(const Matrix3<Scalar>& m) {
  return Vector3<Scalar>(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)) / Scalar(2);
}

template <class Scalar>
Matrix3<Scalar> rotation_of(const Matrix4<Scalar>& pose) {
  return pose.template topLeftCorner<3, 3>();
}

template <class Scalar>
Vector3<Scalar> origin_of(const Matrix4<Scalar>& pose) {
  return pose.template topRightCorner<3, 1>();
}

// Elementary rotation about coordinate axis 0, 1 or 2 by `angle` (rad).
template <class Scalar>
Matrix4<Scalar> rotation(int axis, const Scalar& angle) {
  using std::cos;
  using std::sin;
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  Matrix4<Scalar> m = Matrix4<Scalar>::Identity();
  m(i, i) = cos(angle);
  m(i, j) = -sin(angle);
  m(j, i) = sin(angle);
  m(j, j) = cos(angle);
  return m;
}

template <class Scalar>
Matrix4<Scalar> translation(const Scalar& x, const Scalar& y, const Scalar& z) {
  Matrix4<Scalar> m = Matrix4<Scalar>::Identity();
  m(0, 3) = x;
  m(1, 3) = y;
  m(2, 3) = z;
  return m;
}

// Pose of a frame: translate (m), then rotate about the intrinsic axes x, y', z'' (rad).
template <class Scalar>
Matrix4<Scalar> placement(const double (&t)[3], const double (&r)[3]) {
  return translation(Scalar(t[0]), Scalar(t[1]), Scalar(t[2])) * rotation(0, Scalar(r[0])) * rotation(1, Scalar(r[1])) *
         rotation(2, Scalar(r[2]));
}

// Inverse of a pose.
template <class Scalar>
Matrix4<Scalar> inverse_of(const Matrix4<Scalar>& pose) {
  const Matrix3<Scalar> R = rotation_of(pose);
  Matrix4<Scalar> m = Matrix4<Scalar>::Identity();
  m.template topLeftCorner<3, 3>() = R.transpose();
  m.template topRightCorner<3, 1>() = -(R.transpose() * origin_of(pose));
  return m;
}

// Coordinate transform of twists and spatial accelerations, [[R, 0], [p x R, R]].
template <class Scalar>
Matrix6<Scalar> motion_form(const Matrix4<Scalar>& pose) {
  const Matrix3<Scalar> R = rotation_of(pose);
  Matrix6<Scalar> m = Matrix6<Scalar>::Zero();
  m.template topLeftCorner<3, 3>() = R;
  m.template bottomLeftCorner<3, 3>() = skew(origin_of(pose)) * R;
  m.template bottomRightCorner<3, 3>() = R;
  return m;
}

// Coordinate transform of wrenches, [[R, p x R], [0, R]].
template <class Scalar>
Matrix6<Scalar> force_form(const Matrix4<Scalar>& pose) {
  const Matrix3<Scalar> R = rotation_of(pose);
  Matrix6<Scalar> m = Matrix6<Scalar>::Zero();
  m.template topLeftCorner<3, 3>() = R;
  m.template topRightCorner<3, 3>() = skew(origin_of(pose)) * R;
  m.template bottomRightCorner<3, 3>() = R;
  return m;
}

}  // namespace robcogen::reference
