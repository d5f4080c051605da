#include "export/pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "support/index.h"

namespace robcogen::exporting {

namespace {

constexpr Real kPi = std::numbers::pi_v<Real>;
// Differences of angles, and cosines, below this are rounding errors.
constexpr Real kNegligible = 5e-16L;

// The sine and the cosine of an angle, from its exact form if this is known.
struct SineCosine {
  Real sine, cosine;
};

SineCosine sine_cosine(const Number& angle) {
  if (!angle.is_pi_multiple()) return {std::sin(Real(angle.value())), std::cos(Real(angle.value()))};
  const Number sine = sin(angle), cosine = cos(angle);
  // Both are rational only for multiples of PI/2.
  if (sine.ratio() && cosine.ratio()) return {Real(sine.value()), Real(cosine.value())};
  const Rational& factor = *angle.ratio();
  const Real reduced = std::fmod(Real(factor.num), 2 * Real(factor.den)) / Real(factor.den) * kPi;
  return {std::sin(reduced), std::cos(reduced)};
}

Matrix3 rotation_matrix(const Turn& turn) {
  const auto [s, c] = sine_cosine(turn.angle);
  const std::size_t i = at(turn.axis), j = (i + 1) % 3, k = (i + 2) % 3;
  Matrix3 m{};
  m[i][i] = 1;
  m[j][j] = m[k][k] = c;
  m[j][k] = -s;
  m[k][j] = s;
  return m;
}

void append(std::vector<Turn>& turns, const Turn& turn) {
  if (turn.angle.is_zero()) return;
  if (turns.empty() || turns.back().axis != turn.axis) {
    turns.push_back(turn);
    return;
  }
  turns.back().angle = turns.back().angle + turn.angle;
  if (turns.back().angle.is_zero()) turns.pop_back();
}

// The double for an angle that was computed from turns. If it equals one of their angles, up to its sign and quarter
// turns, the result is exactly that angle.
double nearest_meant(Real angle, const std::vector<Turn>& turns) {
  if (angle < kNegligible - kPi) angle += 2 * kPi;  // -pi and pi are the same turn: rounding must not choose
  std::vector<Number> origins{Number()};
  for (const Turn& turn : turns) origins.insert(origins.end(), {turn.angle, -turn.angle});
  for (const Number& origin : origins) {
    const auto quarters = static_cast<std::int64_t>(std::llround((angle - Real(origin.value())) / (kPi / 2)));
    const Number meant = origin + Number::pi_multiple(quarters, 2);
    const bool is_exact = quarters == 0 || meant.ratio().has_value();
    if (is_exact && std::abs(angle - Real(meant.value())) < kNegligible) return meant.value();
  }
  return static_cast<double>(angle);
}

// Whether the turns are Rz Ry Rx, or a part of this.
bool is_roll_pitch_yaw(const std::vector<Turn>& turns) {
  return std::adjacent_find(
             turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.axis <= b.axis; }) == turns.end();
}

}  // namespace

Pose pose_of(const model::Placement& placement) {
  Pose pose;
  for (int i = 0; i < 3; ++i) {
    assert(placement.translation[at(i)].is_constant() && placement.rotation[at(i)].is_constant());
    pose.translation[at(i)] = placement.translation[at(i)].number().value();
    append(pose.turns, {i, placement.rotation[at(i)].number()});
  }
  return pose;
}

Pose inverse_of(const Pose& pose) {
  Pose inverse;
  for (auto turn = pose.turns.rbegin(); turn != pose.turns.rend(); ++turn)
    append(inverse.turns, {turn->axis, -turn->angle});
  inverse.translation = rotation_matrix(inverse) * pose.translation;
  for (Real& x : inverse.translation) x = -x;
  return inverse;
}

Pose operator*(const Pose& a, const Pose& b) {
  Pose product = a;
  const Vector3 step = rotation_matrix(a) * b.translation;
  for (std::size_t i = 0; i < 3; ++i) product.translation[i] += step[i];
  for (const Turn& turn : b.turns) append(product.turns, turn);
  return product;
}

Matrix3 rotation_matrix(const Pose& pose) {
  Matrix3 m{};
  for (std::size_t i = 0; i < 3; ++i) m[i][i] = 1;
  for (const Turn& turn : pose.turns) m = m * rotation_matrix(turn);
  return m;
}

Vector3 operator*(const Matrix3& m, const Vector3& v) {
  Vector3 product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) product[i] += m[i][j] * v[j];
  }
  return product;
}

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  Matrix3 product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += a[i][k] * b[k][j];
    }
  }
  return product;
}

Matrix3 transpose(const Matrix3& m) {
  Matrix3 t{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) t[i][j] = m[j][i];
  }
  return t;
}

std::array<double, 3> roll_pitch_yaw(const Pose& pose) {
  std::array<double, 3> angles{};
  if (is_roll_pitch_yaw(pose.turns)) {
    for (const Turn& turn : pose.turns) angles[at(turn.axis)] = turn.angle.value();
    return angles;
  }
  // The angles are computed one after the other, each with the final values of the earlier ones: close to a pitch of
  // PI/2, where roll is badly determined, yaw compensates for it.
  const Matrix3 R = rotation_matrix(pose);
  auto& [roll, pitch, yaw] = angles;
  if (std::hypot(R[2][1], R[2][2]) > kNegligible) roll = nearest_meant(std::atan2(R[2][1], R[2][2]), pose.turns);
  const auto [sr, cr] = sine_cosine(Number(roll));
  // R Rx(-roll) = Rz Ry: its second column is that of Rz.
  yaw = nearest_meant(std::atan2(R[0][2] * sr - R[0][1] * cr, R[1][1] * cr - R[1][2] * sr), pose.turns);
  const auto [sy, cy] = sine_cosine(Number(yaw));
  pitch = nearest_meant(std::atan2(-R[2][0], R[0][0] * cy + R[1][0] * sy), pose.turns);
  return angles;
}

}  // namespace robcogen::exporting
