#include "import/parts/placements.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "import/pose.h"

namespace robcogen::import::parts {
namespace {

constexpr std::array<std::size_t, 3> kAxes = {0, 1, 2};

ExpressionPtr zero(Span span) {
  return term(Number(), span);
}

Matrix turn(std::size_t axis, const ExpressionPtr& angle) {
  const ExpressionPtr null = zero(angle->span), one = term(Number::rational(1), angle->span);
  Matrix m = {Vector{one, null, null}, Vector{null, one, null}, Vector{null, null, one}};
  if (is_zero(angle)) return m;
  const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
  m[y][y] = m[z][z] = cosine(angle);
  m[z][y] = sine(angle);
  m[y][z] = negated(m[z][y]);
  return m;
}

bool are_zero(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](const ExpressionPtr& e) { return is_zero(e); });
}

std::optional<std::array<Number, 3>> constants(const Vector& v) {
  std::array<Number, 3> values;
  for (const std::size_t i : kAxes) {
    const std::optional<Number> value = constant(v[i]);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

Vector terms(const std::array<Number, 3>& values, Span span) {
  return {term(values[0], span), term(values[1], span), term(values[2], span)};
}

Rotation rotation(const std::array<Number, 3>& angles) {
  return rotation_about(0, angles[0]) * rotation_about(1, angles[1]) * rotation_about(2, angles[2]);
}

// Returns the combined angles about x, y and z of both rotations, if their turns follow one another in this order.
std::optional<Vector> joined_turns(const Vector& a, const Vector& b) {
  Vector joined = {zero(a[0]->span), zero(a[0]->span), zero(a[0]->span)};
  std::size_t last = 0;
  for (const Vector* angles : {&a, &b}) {
    for (const std::size_t axis : kAxes) {
      if (is_zero((*angles)[axis])) continue;
      if (axis < last) return std::nullopt;
      last = axis;
      joined[axis] = sum(joined[axis], (*angles)[axis]);
    }
  }
  return joined;
}

// Wraps an angle to (-PI, PI].
Number less_than_turn(const Number& angle) {
  const Number turn = Number::pi_multiple(2);
  const double turns = std::ceil((angle.value() - std::numbers::pi) / turn.value() - 1e-9);
  return turns == 0.0 ? angle : angle - Number::rational(static_cast<std::int64_t>(turns)) * turn;
}

double size(const std::array<Number, 3>& angles) {
  double all = 0;
  for (const Number& angle : angles) all += std::abs(angle.value());
  return all;
}

// Returns the smaller of the two sets of angles that give the same rotation.
std::array<Number, 3> least_angles(std::array<Number, 3> angles) {
  const Number half = Number::pi_multiple(1);
  std::array<Number, 3> other = {angles[0] + half, half - angles[1], angles[2] + half};
  for (auto* set : {&angles, &other})
    for (Number& angle : *set) angle = less_than_turn(angle);
  constexpr double kClearly = 1e-9;
  return size(other) < size(angles) - kClearly ? other : angles;
}

}  // namespace

Placement identity(Span span) {
  const ExpressionPtr null = zero(span);
  return {{null, null, null}, {null, null, null}, span};
}

bool is_identity(const Placement& placement) {
  return are_zero(placement.translation) && are_zero(placement.rotation);
}

Matrix rotation_matrix(const Vector& angles) {
  return product(product(turn(0, angles[0]), turn(1, angles[1])), turn(2, angles[2]));
}

Matrix product(const Matrix& a, const Matrix& b) {
  const Matrix columns = transposed(b);
  return transposed({product(a, columns[0]), product(a, columns[1]), product(a, columns[2])});
}

Matrix transposed(const Matrix& m) {
  Matrix t;
  for (const std::size_t i : kAxes)
    for (const std::size_t k : kAxes) t[i][k] = m[k][i];
  return t;
}

Vector product(const Matrix& m, const Vector& v) {
  Vector result;
  for (const std::size_t i : kAxes)
    result[i] = sum(sum(product(m[i][0], v[0]), product(m[i][1], v[1])), product(m[i][2], v[2]));
  return result;
}

Vector sum(const Vector& a, const Vector& b) {
  return {sum(a[0], b[0]), sum(a[1], b[1]), sum(a[2], b[2])};
}

Vector with_signs(const Signs& signs, const Vector& v) {
  Vector result = v;
  for (const std::size_t i : kAxes)
    if (signs[i] < 0) result[i] = negated(v[i]);
  return result;
}

std::optional<Placement> composed(const Placement& a_b, const Placement& b_c) {
  if (is_identity(a_b)) return b_c;
  if (is_identity(b_c)) return Placement{a_b.translation, a_b.rotation, b_c.span};
  Placement result = b_c;
  result.translation =
      sum(a_b.translation,
          are_zero(a_b.rotation) ? b_c.translation : product(rotation_matrix(a_b.rotation), b_c.translation));
  if (const std::optional<Vector> joined = joined_turns(a_b.rotation, b_c.rotation)) {
    result.rotation = are_zero(a_b.rotation) ? b_c.rotation : *joined;
    return result;
  }
  const auto first = constants(a_b.rotation), second = constants(b_c.rotation);
  if (!first || !second) return std::nullopt;
  result.rotation = terms(intrinsic_angles(rotation(*first) * rotation(*second)), b_c.span);
  return result;
}

Placement mirrored(const Placement& placement, const Signs& parent, const Signs& child) {
  Placement result = {with_signs(parent, placement.translation), placement.rotation, placement.span};
  const int determinant = parent[0] * parent[1] * parent[2];
  // P Rk(angle) P is a rotation about the reflected axis, in the opposite sense.
  Vector& angles = result.rotation;
  for (const std::size_t i : kAxes)
    if (determinant * parent[i] < 0) angles[i] = negated(angles[i]);
  // P R C = (P R P) (P C), where P C is the identity or half a turn about one axis.
  const Signs rest = {parent[0] * child[0], parent[1] * child[1], parent[2] * child[2]};
  if (rest == kNoSigns) return result;
  const ExpressionPtr half = term(Number::pi_multiple(1), placement.span);
  const auto axis = static_cast<std::size_t>(std::find(rest.begin(), rest.end(), 1) - rest.begin());
  for (std::size_t i = axis + 1; i < 3; ++i) angles[i] = negated(angles[i]);
  angles[axis] = sum(angles[axis], half);
  if (const auto values = constants(angles)) angles = terms(least_angles(*values), placement.span);
  return result;
}

Signs nearest_image(const Placement& placement, const Signs& parent) {
  const auto reversed_axis = std::find(parent.begin(), parent.end(), -1) - parent.begin();
  const bool is_one_axis = std::count(parent.begin(), parent.end(), -1) == 1;
  if (!is_one_axis || !constants(placement.rotation)) return parent;
  // The row of the reversed axis: the component of each axis of the frame along it.
  const Vector row = rotation_matrix(placement.rotation)[static_cast<std::size_t>(reversed_axis)];
  constexpr double kClearly = 1e-9;
  auto best = static_cast<std::size_t>(reversed_axis);
  const auto along = [&](std::size_t axis) { return std::abs(constant(row[axis])->value()); };
  for (const std::size_t axis : kAxes)
    if (along(axis) > along(best) + kClearly) best = axis;
  return reversed(static_cast<int>(best));
}

}  // namespace robcogen::import::parts
