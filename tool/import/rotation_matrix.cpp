#include "import/rotation_matrix.h"

#include <cmath>

namespace robcogen::import {

namespace {

using Real = long double;

// A few roundings of doubles.
constexpr Real kRounding = 1e-15L;

// atan2, as a multiple of PI/4 where it is one up to rounding.
Number angle_of(Real y, Real x) {
  const Real tolerance = kRounding * std::hypot(x, y);
  const int sign = y < 0 ? -1 : 1;
  if (std::abs(y) <= tolerance) return Number::pi_multiple(x < 0 ? 1 : 0);
  if (std::abs(x) <= tolerance) return Number::pi_multiple(sign, 2);
  if (std::abs(std::abs(x) - std::abs(y)) <= tolerance) return Number::pi_multiple(x < 0 ? 3 * sign : sign, 4);
  return Number(static_cast<double>(std::atan2(y, x)));
}

}  // namespace

// Decomposes R = Rx Ry Rz. If Ry is a quarter turn, only a sum of the other two angles is determined, and Rz is zero.
Rotation rotation_of_matrix(const std::array<std::array<Real, 3>, 3>& R) {
  const Real cosine = std::hypot(R[0][0], R[0][1]);
  const Number y = angle_of(R[0][2], cosine);
  const bool is_singular = cosine <= kRounding;
  const Number z = is_singular ? Number() : angle_of(-R[0][1], R[0][0]);
  // Taken from R Rz', which is accurate even if the cosine is small.
  const Real c = std::cos(static_cast<Real>(z.value())), s = std::sin(static_cast<Real>(z.value()));
  const Number x = angle_of(R[2][0] * s + R[2][1] * c, R[1][0] * s + R[1][1] * c);
  return rotation_about(0, x) * rotation_about(1, y) * rotation_about(2, z);
}

Rotation rotation_of_quaternion(const std::array<Real, 4>& wxyz) {
  auto [w, x, y, z] = wxyz;
  const Real n = w * w + x * x + y * y + z * z;
  w /= std::sqrt(n), x /= std::sqrt(n), y /= std::sqrt(n), z /= std::sqrt(n);
  return rotation_of_matrix(
      {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
       {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
       {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}});
}

}  // namespace robcogen::import
