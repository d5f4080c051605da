// Identities between the functions of one robot, and with its energy and momentum, that hold for every robot. Each
// function records the errors of one sample.
#pragma once

#include "robcogen/reference/check_dynamics.h"
#include "robcogen/reference/energy.h"

namespace robcogen::reference {

inline constexpr Tolerance kExact{"kExact", 0, "structural zeros and symmetry are exact"};
inline constexpr Tolerance kRoundTrip{"kRoundTrip", 1e-11, "forces to accelerations and back, two roundings"};
inline constexpr Tolerance kEnergy{"kEnergy", 1e-12, "rounding of sums over all links"};
inline constexpr Tolerance kDifference{
    "kDifference", 1e-8, "truncation and rounding of a fourth-order difference in double"};

// P1: from forces to accelerations and back.
template <class Subject>
void check_round_trips(const Subject& subject, const Case& c, Checks& checks) {
  const Motion<double>& given = c.sample.motion;
  const int n = c.robot.dof();
  for (const Overload& o : overloads(c.sample)) {
    const Vector<double> forces = subject.inverse_dynamics(given, o.arguments);
    const Vector<double> tau = forces.tail(n);
    Motion<double> motion = given;
    if (c.floating) motion.base_acceleration = forces.head(6);
    const Vector<Real> terms = expected_forces(c, motion, o.loads).terms;

    const Vector<double> back = subject.forward_dynamics(given, tau, o.arguments);
    const Vector<double> wanted = coordinates(c.floating, motion.base_acceleration, motion.qdd);
    checks.record(
        "P1: FD(ID(qdd)) = qdd" + o.suffix, kRoundTrip,
        error_of(c, back, {wanted.cast<Real>(), c.inverse_magnitude * terms}), c.index);

    motion.qdd = back.tail(n);
    const Vector<double> again = subject.inverse_dynamics(motion, o.arguments).tail(n);
    checks.record(
        "P1: ID(FD(tau)) = tau" + o.suffix, kRoundTrip,
        relative_error(again.cast<Real>(), tau.cast<Real>(), terms.tail(n)), c.index);
  }
}

// True if `joint` is `other` or carries it.
inline bool supports(const Robot& robot, int joint, int other) {
  const std::vector<int> path = supporting_joints(robot, robot.joints[other].child);
  return std::find(path.begin(), path.end(), joint) != path.end();
}

inline bool on_one_branch(const Robot& robot, int a, int b) {
  return supports(robot, a, b) || supports(robot, b, a);
}

// True if `joint` moves the link that carries the rotor of joint `turning`.
inline bool moves_rotor(const Robot& robot, int joint, int turning) {
  const int carrier = robot.joints[turning].drive.rotor_carrier;
  if (carrier < 0) return false;
  const std::vector<int> path = supporting_joints(robot, carrier);
  return std::find(path.begin(), path.end(), joint) != path.end();
}

// For each pair of elements of q: 1 if a joint of the first and one of the second are on one branch, or if one moves
// the rotor of the other.
inline Matrix<double> tied_coordinates(const Robot& robot) {
  Matrix<double> tied(robot.dof(), robot.dof());
  for (int i = 0; i < robot.joints.size; ++i)
    for (int j = 0; j < robot.joints.size; ++j) {
      if (!on_one_branch(robot, i, j) && !moves_rotor(robot, i, j) && !moves_rotor(robot, j, i)) continue;
      for (const Mover& a : movers_of(robot, i))
        for (const Mover& b : movers_of(robot, j)) tied(a.coordinate, b.coordinate) = 1;
    }
  return tied;
}

// P2: H is symmetric, positive definite, and zero between branches that nothing ties.
template <class Subject>
void check_inertia_structure(const Subject& subject, const Case& c, Checks& checks) {
  const Matrix<double> H = subject.joint_space_inertia(c.sample.motion.q);
  checks.record("P2: H = H'", kExact, largest(H - transpose(H)), c.index);

  const int first = c.floating ? 6 : 0;
  const Matrix<double> tied = tied_coordinates(c.robot);
  double stray = 0;
  for (int a = 0; a < c.robot.dof(); ++a) {
    for (int b = 0; b < c.robot.dof(); ++b) {
      if (tied(a, b) == 0) stray = std::max(stray, std::abs(H(first + a, first + b)));
    }
  }
  // What followers in loops follow is known in this state only, and but for rounding errors.
  const double rounding = c.robot.loops.size > 0 ? 1e-14 * largest(H) : 0.0;
  checks.record("P2: structural zeros of H", kExact, stray > rounding ? stray : 0.0, c.index);

  // Implausible mass properties, which the generator warns of, make H indefinite, although it is correct.
  if (positive_definite(c.H)) checks.record("P2: H positive definite", kExact, positive_definite(H) ? 0 : 1, c.index);
}

// P2: the columns of H are the inverse dynamics of unit accelerations.
template <class Subject>
void check_inertia_columns(const Subject& subject, const Case& c, Checks& checks) {
  const int first = c.floating ? 6 : 0;
  const Vector<double> weightless(3);
  Matrix<double> columns(c.H.rows(), c.H.cols());
  Matrix<Real> terms = inertia_magnitude(c);
  for (int k = 0; k < columns.cols(); ++k) {
    Motion<double> unit = at_rest(c.robot, c.sample.motion.q);
    // Springs act at rest, too, and their forces are rounded.
    const Vector<double> none = subject.inverse_dynamics_fully_actuated(unit, {&weightless, nullptr});
    if (k < first) unit.base_acceleration(k) = 1;
    if (k >= first) unit.qdd(k - first) = 1;
    columns.set_block(0, k, subject.inverse_dynamics_fully_actuated(unit, {&weightless, nullptr}) - none);
    for (int i = 0; i < terms.rows(); ++i) terms(i, k) += std::abs(none(i));
  }
  const Matrix<double> H = subject.joint_space_inertia(c.sample.motion.q);
  checks.record(
      "P2: columns of H = ID of unit accelerations", kInertia,
      relative_error(columns.cast<Real>(), H.cast<Real>(), terms), c.index);
}

// P3: H agrees with the sums of the links' energies and momenta.
template <class Subject>
void check_energy(const Subject& subject, const Case& c, Checks& checks) {
  const Matrix<Real> H = subject.joint_space_inertia(c.sample.motion.q).template cast<Real>();
  const Vector<Real> velocity = coordinates(c.floating, c.motion.base_velocity, c.motion.qd);
  const Vector<Real> terms = magnitude(H) * magnitude(velocity);
  const Real scale = dot(magnitude(velocity), terms) / 2;
  if (scale == 0) return;
  const Real error = std::abs(dot(velocity, H * velocity) / 2 - kinetic_energy(c.robot, c.motion));
  checks.record("P3: v'Hv/2 = kinetic energy", kEnergy, error / scale, c.index);
  if (!c.floating) return;
  checks.record(
      "P3: base rows of Hv = momentum", kEnergy,
      relative_error((H * velocity).head(6), momentum(c.robot, c.motion), terms.head(6)), c.index);
}

// One, plus the speeds of all joints.
inline double speed_of(const Robot& robot, const Motion<double>& m) {
  double speed = 1;
  const Vector<double> rates = joint_rates(robot, m.qd);
  for (int j = 0; j < rates.rows(); ++j) speed += std::abs(rates(j));
  return speed;
}

// A step for time differences (s): the longest chain rotates by 0.01 rad at most, by less where proportions change.
inline double step_of_time(const Robot& robot, const Motion<double>& m) {
  return (robot.loops.size > 0 ? 1e-3 : 1e-2) / speed_of(robot, m);
}

// P3: dT/dt = v'(H v' + C) for T = v'Hv/2, so that 2 v'C = v'H'v. This relates Coriolis forces to the change of H over
// time.
template <class Subject>
void check_power(const Subject& subject, const Case& c, Checks& checks) {
  if (c.robot.followers.size > 0) return;  // the loops would have to be closed again at other positions
  const Motion<double>& m = c.sample.motion;
  const double step = step_of_time(c.robot, m);
  const double speed = speed_of(c.robot, m);
  const auto inertia = [&](double steps) {
    return subject.joint_space_inertia(moved(c.robot, m.q, steps * step * m.qd));
  };
  const Matrix<double> change = 1 / (12 * step) * (8.0 * (inertia(1) - inertia(-1)) - (inertia(2) - inertia(-2)));
  const Vector<double> velocity = coordinates(c.floating, m.base_velocity, m.qd);
  const Vector<double> coriolis = subject.coriolis_forces(m);
  // When H does not change, only its rounding is visible.
  const Matrix<double> rates = magnitude(change) + speed * magnitude(inertia(0));
  const double scale = dot(magnitude(velocity), magnitude(coriolis) + rates * magnitude(velocity));
  if (scale == 0) return;
  const double error = std::abs(dot(velocity, coriolis) - dot(velocity, change * velocity) / 2);
  checks.record("P3: v'C = v'(dH/dt)v/2", kDifference, error / scale, c.index);
}

// P3: gravity forces are the slopes of the potential energy along each joint, by a fourth-order difference.
template <class Subject>
void check_gravity_gradient(const Subject& subject, const Case& c, Checks& checks) {
  const Real step = 1e-3L;
  const int n = c.robot.dof();
  const Loads<Real> gravity = loads<Real>(c.sample.gravity);
  Vector<Real> slope(n);
  for (int j = 0; j < n; ++j) {
    const auto energy = [&](Real steps) {
      Vector<Real> way(n);
      way(j) = steps * step;
      return potential_energy(c.robot, moved(c.robot, c.motion.q, way), gravity.gravity);
    };
    slope(j) = (8 * (energy(1) - energy(-1)) - (energy(2) - energy(-2))) / (12 * step);
  }
  const Vector<double> forces = subject.gravity_forces(c.sample.motion.q, {&c.sample.gravity, nullptr}).tail(n);
  const Vector<Real> terms = expected_forces(c, at_rest(c.robot, c.sample.motion.q), gravity).terms.tail(n);
  checks.record(
      "P3: gravity_forces = gradient of potential energy", kDifference,
      relative_error(forces.cast<Real>(), slope, terms), c.index);
}

}  // namespace robcogen::reference
