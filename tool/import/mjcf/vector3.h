// Vectors of three numbers.
#pragma once

#include <array>

namespace robcogen::import::from_mjcf {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;  // rows

template <class Real>
std::array<Real, 3> operator+(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class Real>
std::array<Real, 3> operator-(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Real>
Real dot(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
std::array<Real, 3> cross(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vector3 operator*(const Matrix3& A, const Vector3& v) {
  return {dot(A[0], v), dot(A[1], v), dot(A[2], v)};
}

}  // namespace robcogen::import::from_mjcf
