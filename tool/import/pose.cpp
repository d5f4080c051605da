#include "import/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "support/index.h"

namespace robcogen::import {

namespace {

using Real = long double;
constexpr Real kPi = std::numbers::pi_v<Real>;

using QuarterTurns = std::array<std::array<int, 3>, 3>;
using Matrix = std::array<std::array<Real, 3>, 3>;

// A rotation with more turns is reduced to three.
constexpr std::size_t kMaxTurns = 12;

// --- quarter turns ----------------------------------------------------------------------------------------------

// Returns the number of quarter turns if the angle is exactly a multiple of PI/2.
std::optional<int> quarter_turns_in(const Number& angle) {
  if (angle.is_zero()) return 0;
  if (!angle.is_pi_multiple() || angle.ratio()->den > 2) return std::nullopt;
  const std::int64_t halves = angle.ratio()->den == 2 ? angle.ratio()->num % 4 : 2 * (angle.ratio()->num % 2);
  return static_cast<int>((halves + 4) % 4);
}

template <class Element>
using Matrix3 = std::array<std::array<Element, 3>, 3>;

template <class Element>
Matrix3<Element> operator*(const Matrix3<Element>& a, const Matrix3<Element>& b) {
  Matrix3<Element> c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j) c[i][j] += a[i][k] * b[k][j];
  return c;
}

template <class Element>
Matrix3<Element> transpose(const Matrix3<Element>& m) {
  Matrix3<Element> t{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) t[i][j] = m[j][i];
  return t;
}

template <class Element>
Matrix3<Element> turn_matrix(int axis, Element sine, Element cosine) {
  const std::size_t x = at(axis), y = (x + 1) % 3, z = (x + 2) % 3;
  Matrix3<Element> m{};
  m[x][x] = 1;
  m[y][y] = m[z][z] = cosine;
  m[y][z] = -sine, m[z][y] = sine;
  return m;
}

QuarterTurns quarter_turns(int axis, int count) {
  constexpr std::array<int, 4> kSines = {0, 1, 0, -1};
  return turn_matrix(axis, kSines[at(count)], kSines[at((count + 1) % 4)]);
}

// rotation = rotation * turn
void append(Rotation& rotation, const Turn& turn) {
  if (const auto count = quarter_turns_in(turn.angle)) {
    rotation.quarter_turns = rotation.quarter_turns * quarter_turns(turn.axis, *count);
    return;
  }
  // Q R(axis, angle) = R(Q axis, angle) Q
  Turn seen;
  for (int i = 0; i < 3; ++i) {
    const int sign = rotation.quarter_turns[at(i)][at(turn.axis)];
    if (sign != 0) seen = {i, sign > 0 ? turn.angle : -turn.angle};
  }
  if (rotation.turns.empty() || rotation.turns.back().axis != seen.axis) {
    rotation.turns.push_back(seen);
    return;
  }
  Number& sum = rotation.turns.back().angle;
  sum = sum + seen.angle;
  if (const auto count = quarter_turns_in(sum)) {
    rotation.turns.pop_back();
    rotation.quarter_turns = quarter_turns(seen.axis, *count) * rotation.quarter_turns;
  }
}

// --- angles -----------------------------------------------------------------------------------------------------

Matrix matrix_of(const Rotation& rotation, const std::vector<Real>& angles) {
  Matrix m = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < angles.size(); ++i)
    m = m * turn_matrix(rotation.turns[i].axis, std::sin(angles[i]), std::cos(angles[i]));
  Matrix rest{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) rest[i][j] = static_cast<Real>(rotation.quarter_turns[i][j]);
  return m * rest;
}

// An angle that a rotation may have: its value in the matrix under examination, and its exact meaning.
struct Candidate {
  Real value;
  Number meaning;
};

bool is_same_angle(Real a, Real b, Real tolerance) {
  return std::abs(std::remainder(a - b, 2 * kPi)) <= tolerance;
}

struct Angles {
  std::array<Number, 3> angles;
  bool all_are_candidates = false;
};

// Returns the first candidate that equals the angle, or else the nearest double; and whether it is a candidate.
std::pair<Number, bool> meaning_of(Real angle, const std::vector<Candidate>& candidates, Real tolerance) {
  for (const Candidate& c : candidates)
    if (is_same_angle(angle, c.value, tolerance)) return {c.meaning, true};
  return {Number(static_cast<double>(angle)), false};
}

// Returns Rx and Ry for a known Rz: R Rz' = Rx Ry.
Angles angles_for(
    const Matrix& R,
    Real rz,
    const std::pair<Number, bool>& rz_meaning,
    const std::vector<Candidate>& candidates,
    Real tolerance) {
  const Matrix xy = R * turn_matrix(2, std::sin(-rz), std::cos(-rz));
  const auto [x, x_is_candidate] = meaning_of(std::atan2(xy[2][1], xy[1][1]), candidates, tolerance);
  const auto [y, y_is_candidate] = meaning_of(std::atan2(xy[0][2], xy[0][0]), candidates, tolerance);
  return {{x, y, rz_meaning.first}, x_is_candidate && y_is_candidate && rz_meaning.second};
}

// The nearer Ry is to a quarter turn, the less Rz matters on its own: any candidate that moves the matrix by no more
// than the tolerance is accepted.
Angles angles_of(const Matrix& R, const std::vector<Candidate>& candidates, Real tolerance) {
  constexpr Real kAnyAngle = 2 * kPi;
  const Real cosine = std::hypot(R[0][0], R[0][1]);
  const Real rz = std::atan2(-R[0][1], R[0][0]);
  const auto is_rz = [&](const Candidate& c) {
    return is_same_angle(rz, c.value, cosine > tolerance ? tolerance / cosine : kAnyAngle);
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), is_rz);
  if (found != candidates.end()) return angles_for(R, found->value, {found->meaning, true}, candidates, tolerance);
  return angles_for(R, rz, {Number(static_cast<double>(rz)), false}, candidates, tolerance);
}

// Computes with other angles in place of those of the rotation, free of accidental equalities, so that the result holds
// for any angles.
Angles angles_by_structure(const Rotation& rotation) {
  constexpr Real kTolerance = 1e-14L;
  std::vector<Real> angles;
  std::vector<Candidate> candidates = {{0, Number()}};
  for (std::size_t i = 0; i < rotation.turns.size(); ++i) {
    angles.push_back(0.1L + 0.7L * std::fmod(static_cast<Real>(i + 1) * std::numbers::phi_v<Real>, 1.0L));
    candidates.push_back({angles[i], rotation.turns[i].angle});
    candidates.push_back({-angles[i], -rotation.turns[i].angle});
  }
  for (const int quarters : {1, -1, 2}) {
    const std::size_t plain = 1 + 2 * rotation.turns.size();
    for (std::size_t i = 0; i < plain; ++i) {
      const Candidate c = candidates[i];
      candidates.push_back({c.value + quarters * kPi / 2, c.meaning + Number::pi_multiple(quarters, 2)});
    }
  }
  return angles_of(matrix_of(rotation, angles), candidates, kTolerance);
}

Real value_of(const Number& angle) {
  if (!angle.is_pi_multiple()) return angle.value();
  return static_cast<Real>(angle.ratio()->num) / static_cast<Real>(angle.ratio()->den) * kPi;
}

Angles angles_by_value(const Rotation& rotation) {
  constexpr Real kTolerance = 1e-15L;  // a few roundings of a matrix of doubles
  std::vector<Real> angles;
  std::vector<Candidate> candidates = {{0, Number()}};
  bool all_are_multiples = true;
  for (const Turn& turn : rotation.turns) {
    angles.push_back(value_of(turn.angle));
    candidates.push_back({angles.back(), turn.angle});
    candidates.push_back({-angles.back(), -turn.angle});
    all_are_multiples = all_are_multiples && turn.angle.is_pi_multiple();
  }
  // Candidates that are not multiples of PI come first: an angle that matches both kinds is not made exact.
  std::stable_partition(
      candidates.begin() + 1, candidates.end(), [](const Candidate& c) { return !c.meaning.is_pi_multiple(); });
  for (int k = -11; k <= 12 && all_are_multiples; ++k) candidates.push_back({k * kPi / 12, Number::pi_multiple(k, 12)});
  return angles_of(matrix_of(rotation, angles), candidates, kTolerance);
}

// atan2, as a multiple of PI/4 where it is exactly one.
Number exact_atan2(const Number& y, const Number& x) {
  const double ay = std::abs(y.value()), ax = std::abs(x.value());
  const int sign = y.value() < 0.0 ? -1 : 1;
  if (y.is_zero()) return Number::pi_multiple(x.value() < 0.0 ? 1 : 0);
  if (x.is_zero()) return Number::pi_multiple(sign, 2);
  if (ax == ay) return Number::pi_multiple(x.value() < 0.0 ? 3 * sign : sign, 4);
  return Number(static_cast<double>(std::atan2(static_cast<Real>(y.value()), static_cast<Real>(x.value()))));
}

}  // namespace

Rotation rotation_about(int axis, const Number& angle) {
  Rotation result;
  append(result, {axis, angle});
  return result;
}

Rotation rotation_of_rpy(const std::array<Number, 3>& roll_pitch_yaw) {
  Rotation result;
  for (const int axis : {2, 1, 0}) append(result, {axis, roll_pitch_yaw[at(axis)]});
  return result;
}

Rotation rotation_to_axis(const std::array<Number, 3>& axis) {
  const auto& [x, y, z] = axis;
  Rotation result = rotation_about(0, exact_atan2(-y, z));
  const bool is_plain = y.is_zero() || z.is_zero();
  const Number beside(is_plain ? std::abs(y.value() + z.value()) : std::hypot(y.value(), z.value()));
  append(result, {1, exact_atan2(x, beside)});
  return result;
}

Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation product = a;
  for (const Turn& turn : b.turns) append(product, turn);
  product.quarter_turns = product.quarter_turns * b.quarter_turns;
  if (product.turns.size() <= kMaxTurns) return product;
  const std::array<Number, 3> angles = intrinsic_angles(product);
  return rotation_about(0, angles[0]) * rotation_about(1, angles[1]) * rotation_about(2, angles[2]);
}

Rotation inverse(const Rotation& rotation) {
  Rotation result;
  result.quarter_turns = transpose(rotation.quarter_turns);
  for (auto turn = rotation.turns.rbegin(); turn != rotation.turns.rend(); ++turn)
    append(result, {turn->axis, -turn->angle});
  return result;
}

std::array<Number, 3> intrinsic_angles(const Rotation& rotation) {
  const Angles structural = angles_by_structure(rotation);
  return structural.all_are_candidates ? structural.angles : angles_by_value(rotation).angles;
}

Pose operator*(const Pose& a, const Pose& b) {
  const auto R = model::rotation_matrix(placement_of(a));
  Pose product = {a.translation, a.rotation * b.rotation};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) product.translation[i] = product.translation[i] + R[i][j] * b.translation[j];
  return product;
}

Pose inverse(const Pose& pose) {
  const Pose shift = {{-pose.translation[0], -pose.translation[1], -pose.translation[2]}, {}};
  return Pose{{}, inverse(pose.rotation)} * shift;
}

model::Placement placement_of(const Pose& pose) {
  const std::array<Number, 3> angles = intrinsic_angles(pose.rotation);
  return {pose.translation, {model::Quantity(angles[0]), model::Quantity(angles[1]), model::Quantity(angles[2])}};
}

}  // namespace robcogen::import
