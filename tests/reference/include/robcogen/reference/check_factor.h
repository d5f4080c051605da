// Checks of the factor L of H = L^T L, and of solutions with it. Each function records the errors of one sample.
#pragma once

#include "robcogen/reference/check_identities.h"

namespace robcogen::reference {

inline constexpr Tolerance kFactor{
    "kFactor", 1e-12, "rounding of sums whose terms are bounded by the diagonal of H, carried through its inverse"};

// True if a rotor is on a link that does not carry the rotor's joint.
inline bool has_rotor_elsewhere(const Robot& robot) {
  for (int turning = 0; turning < robot.joints.size; ++turning)
    for (int joint = 0; joint < robot.joints.size; ++joint)
      if (moves_rotor(robot, joint, turning) && (joint == turning || !supports(robot, joint, turning))) return true;
  return false;
}

// True if coordinate b is a, or carries it. With a floating base its six coordinates come first, each the ancestor of
// the next. Coupled joints, and rotors that are not on the path to their joints, may tie any coordinates, in an order
// that the library chooses.
inline bool carries(const Robot& robot, int b, int a) {
  const int first = robot.floating_base ? 6 : 0;
  if (robot.couplings.size > 0 || has_rotor_elsewhere(robot)) return true;
  if (b < first) return b <= a;
  if (a < first) return false;
  const std::vector<int> path = supporting_joints(robot, robot.joints[a - first].child);
  return std::find(path.begin(), path.end(), b - first) != path.end();
}

// For each coordinate a: whether b carries it.
using Ancestors = std::vector<std::vector<bool>>;

inline Ancestors ancestors(const Robot& robot) {
  const int size = robot.dof() + (robot.floating_base ? 6 : 0);
  Ancestors table;
  for (int a = 0; a < size; ++a) {
    table.emplace_back();
    for (int b = 0; b < size; ++b) table.back().push_back(carries(robot, b, a));
  }
  return table;
}

// The largest element where L must be zero.
inline double stray_of_triangle(const Ancestors& table, const Matrix<double>& L) {
  double stray = 0;
  for (int a = 0; a < L.rows(); ++a) {
    for (int b = 0; b < L.cols(); ++b)
      if (!table[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)]) stray = std::max(stray, std::abs(L(a, b)));
  }
  return stray;
}

// The same for H^-1, which is zero unless some coordinate carries both.
inline double stray_of_inverse(const Ancestors& table, const Matrix<double>& inverse) {
  double stray = 0;
  for (int a = 0; a < inverse.rows(); ++a) {
    for (int b = 0; b < inverse.cols(); ++b) {
      const std::vector<bool>&of_a = table[static_cast<std::size_t>(a)], &of_b = table[static_cast<std::size_t>(b)];
      bool common = false;
      for (std::size_t k = 0; k < of_a.size(); ++k) common = common || (of_a[k] && of_b[k]);
      if (!common) stray = std::max(stray, std::abs(inverse(a, b)));
    }
  }
  return stray;
}

template <class Subject>
void check_inertia_factor(const Subject& subject, const Case& c, Checks& checks) {
  // Implausible mass properties, which the generator warns of, make H indefinite, so that it has no factor.
  if (!positive_definite(c.H)) return;
  const Vector<Real> acceleration = coordinates(c.floating, c.motion.base_acceleration, c.motion.qdd);
  const Vector<Real> x = c.H * acceleration;
  const FactorResults found = subject.inertia_factor(c.sample.motion.q, x.cast<double>());
  const Matrix<Real> L = found.L.template cast<Real>(), inverse_L = found.inverse_L.template cast<Real>();
  const Matrix<Real> inverse = found.inverse.template cast<Real>();
  const Matrix<Real> unit = Matrix<Real>::identity(c.H.rows());
  const Matrix<Real> H_terms = inertia_magnitude(c);
  const Ancestors table = ancestors(c.robot);

  checks.record("L'L = H", kFactor, relative_error(transpose(L) * L, c.H, H_terms), c.index);
  checks.record(
      "structural zeros of L and L^-1", kExact,
      std::max(stray_of_triangle(table, found.L), stray_of_triangle(table, found.inverse_L)), c.index);
  int not_positive = 0;
  for (int i = 0; i < L.rows(); ++i) not_positive += L(i, i) > 0 ? 0 : 1;
  checks.record("diagonal of L is positive", kExact, not_positive, c.index);
  checks.record(
      "L^-1 L = 1", kFactor, relative_error(inverse_L * L, unit, magnitude(inverse_L) * magnitude(L)), c.index);

  checks.record("H^-1 is symmetric", kExact, largest(found.inverse - transpose(found.inverse)), c.index);
  checks.record("structural zeros of H^-1", kExact, stray_of_inverse(table, found.inverse), c.index);
  checks.record(
      "inverse of H", kFactor,
      relative_error(inverse, solve(c.H, unit), c.inverse_magnitude * H_terms * c.inverse_magnitude), c.index);
  checks.record(
      "H^-1 x", kFactor,
      error_of(c, found.solution, {acceleration, c.inverse_magnitude * (H_terms * magnitude(acceleration))}), c.index);
}

// Forward dynamics by another method: H^-1 (tau - bias forces).
template <class Subject>
void check_factor_dynamics(const Subject& subject, const Case& c, Checks& checks) {
  if (!positive_definite(c.H)) return;
  const Motion<double>& m = c.sample.motion;
  const Loads<Real> standard = loads<Real>({0, 0, -9.81});
  const Vector<double> tau = inverse_dynamics(c.robot, c.motion, standard).tau.cast<double>();
  const Vector<double> missing = coordinates(c.floating, Vector<double>(6), tau) - subject.bias_forces(m, {});
  Expected wanted = expected_accelerations(c, tau, standard);
  wanted.value = subject.forward_dynamics(m, tau, {}).template cast<Real>();
  checks.record(
      "H^-1 (tau - bias forces) = forward_dynamics", kRoundTrip,
      error_of(c, subject.inertia_factor(m.q, missing).solution, wanted), c.index);
}

}  // namespace robcogen::reference
