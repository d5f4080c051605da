#include "model/rotations.h"

#include <cmath>

#include "model/kinematic_tree.h"

namespace robcogen::model {
namespace {

// Elements of a rotation matrix, and angles, that differ by less than this differ by rounding.
constexpr double kRounding = 1e-15;

// Returns the angle with this sine and cosine. A multiple of PI/4 is exact.
Quantity angle_of(const Quantity& sine, const Quantity& cosine) {
  const Quantity eighth(Number::pi_multiple(1, 4));
  const double angle = std::atan2(sine.number().value() + 0.0, cosine.number().value());  // + 0.0: not -0.0
  const double count = std::round(angle / eighth.number().value());
  const Number nearest = Number::pi_multiple(static_cast<int>(count), 4);
  return std::abs(angle - nearest.value()) <= kRounding ? Quantity(nearest) : Quantity(angle);
}

bool vanishes(const Quantity& q) {
  return std::abs(q.number().value()) <= kRounding;
}

bool is_constant(const std::array<Quantity, 3>& angles, std::size_t first, std::size_t second) {
  return angles[first].is_constant() && angles[second].is_constant();
}

RotationMatrix matrix(const Quantity& x, const Quantity& y, const Quantity& z) {
  return rotation_matrix({{}, {x, y, z}});
}

}  // namespace

RotationMatrix product(const RotationMatrix& a, const RotationMatrix& b) {
  RotationMatrix c;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return c;
}

RotationMatrix transposed(const RotationMatrix& m) {
  RotationMatrix t;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) t[i][j] = m[j][i];
  return t;
}

std::array<Quantity, 3> product(const RotationMatrix& m, const std::array<Quantity, 3>& v) {
  std::array<Quantity, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

std::array<Quantity, 3> angles_of(const RotationMatrix& R) {
  if (vanishes(R[1][2]) && vanishes(R[2][2]))
    return {angle_of(R[2][1], R[1][1]), angle_of(R[0][2], Quantity()), Quantity()};
  const Quantity x = angle_of(-R[1][2], R[2][2]);
  // The other two are read from Rx^T R = Ry Rz, so that they fit x even where small elements leave it inaccurate.
  const Quantity s = sin(x), c = cos(x);
  return {
      x, angle_of(R[0][2], c * R[2][2] - s * R[1][2]), angle_of(c * R[1][0] + s * R[2][0], c * R[1][1] + s * R[2][1])};
}

std::optional<std::array<Quantity, 3>> turned_by(
    const std::array<Quantity, 3>& first,
    const std::array<Quantity, 3>& second) {
  const auto& [a, b, c] = first;
  const auto& [d, e, f] = second;
  if (d.is_zero() && e.is_zero()) return std::array{a, b, c + f};
  if (b.is_zero() && c.is_zero()) return std::array{a + d, e, f};
  if (c.is_zero() && d.is_zero()) return std::array{a, b + e, f};
  if (!is_constant(first, 1, 2) || !is_constant(second, 0, 1)) return std::nullopt;
  const Quantity none;
  const auto [x, y, z] = angles_of(product(matrix(none, b, c), matrix(d, e, none)));
  return std::array{a + x, y, z + f};
}

std::optional<Placement> placed_in(const Placement& outer, const Placement& inner) {
  const auto rotation = turned_by(outer.rotation, inner.rotation);
  if (!rotation) return std::nullopt;
  const std::array<Quantity, 3> moved = product(rotation_matrix(outer), inner.translation);
  Placement result = {outer.translation, *rotation};
  for (std::size_t i = 0; i < 3; ++i) result.translation[i] = result.translation[i] + moved[i];
  return result;
}

}  // namespace robcogen::model
