// Exponential of rigid motions, its inverse, and the derivatives of both, for pose.h.
//
// A turn is a vector along the axis whose length is the angle (rad). Everything is computed from Stumpff's functions,
// so no quotient loses digits at small angles.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "robcogen/matrix.h"

namespace robcogen {
namespace exponential {

// Stumpff's functions c_k = sum over i of (-t^2)^i / (2 i + k)!: c_1 = sin(t) / t, c_2 = (1 - cos(t)) / t^2,
// c_3 = (t - sin(t)) / t^3, and c_k = 1 / k! - t^2 c_(k+2) (Danby, Fundamentals of Celestial Mechanics, 1988, 6.9).
template <class Scalar>
struct Stumpff {
  Scalar c1, c2, c3, c4, c5;
};

// k! c_k, for t^2 <= 1. The first omitted term is below 1e-19.
template <class Scalar>
Scalar stumpff_series(int k, const Scalar& squared_angle) noexcept {
  constexpr int kTerms = 9;
  Scalar sum(1);
  for (int i = kTerms; i > 0; --i) sum = Scalar(1) - squared_angle / Scalar((2 * i - 1 + k) * (2 * i + k)) * sum;
  return sum;
}

template <class Scalar>
Stumpff<Scalar> stumpff(const Scalar& squared_angle) noexcept {
  using std::sin, std::sqrt;
  const Scalar& x = squared_angle;
  const Scalar half = Scalar(1) / Scalar(2), sixth = Scalar(1) / Scalar(6);
  if (x < Scalar(1)) {
    const Scalar c4 = stumpff_series(4, x) / Scalar(24), c5 = stumpff_series(5, x) / Scalar(120);
    const Scalar c2 = half - x * c4, c3 = sixth - x * c5;
    return {Scalar(1) - x * c3, c2, c3, c4, c5};
  }
  const Scalar t = sqrt(x), s = sin(half * t);
  const Scalar c1 = sin(t) / t, c2 = Scalar(2) * s * s / x, c3 = (Scalar(1) - c1) / x;
  return {c1, c2, c3, (half - c2) / x, (sixth - c3) / x};
}

// [v] with [v] u = v x u.
template <class Scalar>
Matrix<Scalar, 3, 3> cross_matrix(const Eigen::Matrix<Scalar, 3, 1>& v) noexcept {
  Matrix<Scalar, 3, 3> result;
  result << Scalar(0), -v.z(), v.y(), v.z(), Scalar(0), -v.x(), -v.y(), v.x(), Scalar(0);
  return result;
}

template <class Scalar>
Eigen::Quaternion<Scalar> quaternion(const Eigen::Matrix<Scalar, 3, 1>& turn) noexcept {
  const Scalar quarter = turn.squaredNorm() / Scalar(4);  // square of half of the angle
  const Stumpff<Scalar> half = stumpff(quarter);
  const Eigen::Matrix<Scalar, 3, 1> v = half.c1 / Scalar(2) * turn;
  return Eigen::Quaternion<Scalar>(Scalar(1) - quarter * half.c2, v.x(), v.y(), v.z());
}

// Inverse of `quaternion`, with a result of at most half a turn. atan2 keeps all digits from 0 to pi, whereas an arc
// cosine loses half of them at either end.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> rotation_vector(const Eigen::Quaternion<Scalar>& q) noexcept {
  using std::atan2, std::sqrt;
  const Scalar sign = q.w() < Scalar(0) ? Scalar(-1) : Scalar(1);  // both signs represent the same rotation
  const Scalar squared = q.vec().squaredNorm();
  if (squared == Scalar(0)) return Scalar(2) * sign * q.vec();
  const Scalar sine = sqrt(squared);
  return Scalar(2) * sign * atan2(sine, sign * q.w()) / sine * q.vec();
}

// The displacement of a body that moves for a unit of time with constant twist (turn, shift), in its initial axes:
// V shift with V = 1 + c_2 [turn] + c_3 [turn]^2 (Barfoot, State Estimation for Robotics, 2017, eq. 7.37).
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> displacement(
    const Eigen::Matrix<Scalar, 3, 1>& turn,
    const Eigen::Matrix<Scalar, 3, 1>& shift) noexcept {
  const Stumpff<Scalar> c = stumpff<Scalar>(turn.squaredNorm());
  const Eigen::Matrix<Scalar, 3, 1> once = turn.cross(shift), twice = turn.cross(once);
  return shift + c.c2 * once + c.c3 * twice;
}

// V^-1 = 1 - [turn] / 2 + k [turn]^2 with k = (1 - t / 2 cot(t / 2)) / t^2 = (c_3 - 2 c_4) / (2 c_2), for turns below a
// full one.
template <class Scalar>
Scalar inverse_coefficient(const Stumpff<Scalar>& c) noexcept {
  return (c.c3 - Scalar(2) * c.c4) / (Scalar(2) * c.c2);
}

// Inverse of `displacement`.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> shift_of_displacement(
    const Eigen::Matrix<Scalar, 3, 1>& turn,
    const Eigen::Matrix<Scalar, 3, 1>& displacement) noexcept {
  const Eigen::Matrix<Scalar, 3, 1> once = turn.cross(displacement), twice = turn.cross(once);
  return displacement - once / Scalar(2) + inverse_coefficient(stumpff<Scalar>(turn.squaredNorm())) * twice;
}

// Derivative of the displacement by the turn. The slopes of the coefficients are dc_2 / dt = t (2 c_4 - c_3) and
// dc_3 / dt = t (3 c_5 - c_4).
template <class Scalar>
Matrix<Scalar, 3, 3> displacement_by_turn(
    const Eigen::Matrix<Scalar, 3, 1>& turn,
    const Eigen::Matrix<Scalar, 3, 1>& shift) noexcept {
  using Matrix3 = Matrix<Scalar, 3, 3>;
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  const Stumpff<Scalar> c = stumpff<Scalar>(turn.squaredNorm());
  const Vector3 once = turn.cross(shift), twice = turn.cross(once);
  const Vector3 by_angle = (Scalar(2) * c.c4 - c.c3) * once + (Scalar(3) * c.c5 - c.c4) * twice;
  const Matrix3 twice_by_turn =
      turn.dot(shift) * Matrix3::Identity() + turn * shift.transpose() - Scalar(2) * shift * turn.transpose();
  return -c.c2 * cross_matrix(shift) + c.c3 * twice_by_turn + by_angle * turn.transpose();
}

// The right Jacobian Jr: small changes d of the six elements of (turn, shift) move the body, in its own coordinates
// after the motion, by the twist Jr d (Barfoot 2017, sec. 7.1.5 has the left Jacobian, of (shift, turn)).
template <class Scalar>
Matrix<Scalar, 6, 6> right_jacobian(
    const Eigen::Matrix<Scalar, 3, 1>& turn,
    const Eigen::Matrix<Scalar, 3, 1>& shift) noexcept {
  using Matrix3 = Matrix<Scalar, 3, 3>;
  const Stumpff<Scalar> c = stumpff<Scalar>(turn.squaredNorm());
  const Matrix3 W = cross_matrix(turn), W2 = W * W;
  const Matrix3 diagonal = Matrix3::Identity() - c.c2 * W + c.c3 * W2;
  const Matrix3 turned_back = Matrix3::Identity() - c.c1 * W + c.c2 * W2;
  Matrix<Scalar, 6, 6> J = Matrix<Scalar, 6, 6>::Zero();
  J.template topLeftCorner<3, 3>() = diagonal;
  J.template bottomRightCorner<3, 3>() = diagonal;
  J.template bottomLeftCorner<3, 3>() = turned_back * displacement_by_turn(turn, shift);
  return J;
}

// Inverse of `right_jacobian`, by blocks; for turns below a full one.
template <class Scalar>
Matrix<Scalar, 6, 6> inverse_right_jacobian(
    const Eigen::Matrix<Scalar, 3, 1>& turn,
    const Eigen::Matrix<Scalar, 3, 1>& shift) noexcept {
  using Matrix3 = Matrix<Scalar, 3, 3>;
  const Scalar k = inverse_coefficient(stumpff<Scalar>(turn.squaredNorm()));
  const Matrix3 W = cross_matrix(turn);
  const Matrix3 diagonal = Matrix3::Identity() + W / Scalar(2) + k * (W * W);
  Matrix<Scalar, 6, 6> J = right_jacobian(turn, shift);
  const Matrix3 below = J.template bottomLeftCorner<3, 3>();
  J.template topLeftCorner<3, 3>() = diagonal;
  J.template bottomRightCorner<3, 3>() = diagonal;
  J.template bottomLeftCorner<3, 3>() = -(diagonal * below * diagonal);
  return J;
}

}  // namespace exponential
}  // namespace robcogen
