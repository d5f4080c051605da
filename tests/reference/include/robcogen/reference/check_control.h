// Checks of functions for controllers: centre of mass, centroidal momentum, energies, and the Coriolis matrix. Each
// function records the errors of one sample.
#pragma once

#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/loops.h"

namespace robcogen::reference {

inline constexpr Tolerance kCenter{"kCenter", 1e-13, "rounding of sums over links, relative to the sum of lengths"};
inline constexpr Tolerance kSkew{
    "kSkew", 1e-11, "a fourth-order difference of 1e-4 rad of the reference, rounded as far as double has it"};

// Upper bound (m) of the sums from which the centre of mass is computed: mass times distance of each link, over the
// mass.
inline Real center_length(const Case& c, Real mass) {
  const std::vector<Matrix<Real>> poses = link_poses(c.robot, c.motion.q);
  Real sum = 0;
  for (int i = first_moving_link(c.robot); i < c.robot.links.size; ++i) {
    const reflection::Link& link = c.robot.links[i];
    // Origins along the path are part of the sum, even if the link ends up near the base.
    Real reach = largest(center_of_mass<Real>(link)) + largest(origin_of(poses[static_cast<std::size_t>(i)]));
    for (const int j : supporting_joints(c.robot, i))
      reach += largest(origin_of(poses[static_cast<std::size_t>(c.robot.joints[j].child)]));
    sum += std::abs(static_cast<Real>(link.mass)) * reach;
  }
  return sum / mass;
}

// Checks the centre of mass and its velocity. Errors are relative to the lengths that enter, and to these times the
// speeds.
template <class Subject>
void check_center_of_mass(const Subject& subject, const Case& c, Checks& checks) {
  const Vector<double>& q = c.sample.motion.q;
  const Real mass = moving_mass(c.robot);
  const Matrix<Real> J = subject.center_of_mass_jacobian(q).template cast<Real>();
  const Vector<Real> com = subject.center_of_mass(q).template cast<Real>();
  if (mass == 0) {
    checks.record("center_of_mass of nothing", kExact, largest(com) + largest(J), c.index);
    return;
  }
  const Real length = center_length(c, mass);
  if (length > 0) {
    const Vector<Real> expected = 1 / mass * first_moment(c.robot, c.motion.q);
    checks.record("center_of_mass", kCenter, largest(com - expected) / length, c.index);
  }
  const Vector<Real> velocity = coordinates(c.floating, c.motion.base_velocity, c.motion.qd);
  const Vector<Real> expected = 1 / mass * momentum(c.robot, c.motion).tail(3);
  const Real terms = largest(magnitude(J) * magnitude(velocity)) + length * largest(magnitude(velocity));
  if (terms > 0) checks.record("center_of_mass_jacobian", kForce, largest(J * velocity - expected) / terms, c.index);
}

// Angular momentum is about the centre of mass.
template <class Subject>
void check_centroidal_momentum(const Subject& subject, const Case& c, Checks& checks) {
  const Real mass = moving_mass(c.robot);
  const Matrix<Real> A = subject.centroidal_momentum_matrix(c.sample.motion.q).template cast<Real>();
  const Vector<Real> velocity = coordinates(c.floating, c.motion.base_velocity, c.motion.qd);
  const Vector<Real> about_origin = momentum(c.robot, c.motion);
  const Vector<Real> linear = about_origin.tail(3);
  Vector<Real> com(3);
  if (mass != 0) com = 1 / mass * first_moment(c.robot, c.motion.q);
  const Vector<Real> expected = stacked(about_origin.head(3) - cross(com, linear), linear);
  // Moving the momentum from the base origin adds terms of its own.
  const Vector<Real> sums = magnitude(A) * magnitude(velocity);
  const Real lever = mass == 0 ? 0 : center_length(c, mass);
  const Real linear_terms = largest(sums.tail(3));
  const Real angular_terms = largest(sums.head(3)) + lever * linear_terms;
  const Vector<Real> error = A * velocity - expected;
  if (linear_terms > 0)
    checks.record("centroidal_momentum_matrix (linear)", kForce, largest(error.tail(3)) / linear_terms, c.index);
  if (angular_terms > 0)
    checks.record("centroidal_momentum_matrix (angular)", kForce, largest(error.head(3)) / angular_terms, c.index);
}

// P3: under gravity alone, the momentum of a robot changes by its weight only: d/dt(A v) + w x (A v) = (0, m g) in the
// rotating axes of the base.
template <class Subject>
void check_free_fall(const Subject& subject, const Case& c, Checks& checks) {
  // With followers in q, the loops would have to be closed again at other positions.
  if (!c.floating || c.robot.followers.size > 0) return;
  const Motion<double>& m = c.sample.motion;
  const double speed = speed_of(c.robot, m), step = step_of_time(c.robot, m);
  const auto matrix = [&](double steps) {
    return subject.centroidal_momentum_matrix(moved(c.robot, m.q, steps * step * m.qd));
  };
  const Matrix<double> change = 1 / (12 * step) * (8.0 * (matrix(1) - matrix(-1)) - (matrix(2) - matrix(-2)));
  const Loads<Real> gravity = loads<Real>(c.sample.gravity);
  const Vector<double> tau = inverse_dynamics(c.robot, c.motion, gravity).tau.cast<double>();
  const Vector<double> acceleration = subject.forward_dynamics(m, tau, {&c.sample.gravity, nullptr});
  const Vector<double> velocity = coordinates(true, m.base_velocity, m.qd);
  const Matrix<double> A = matrix(0);
  const Vector<double> momentum = A * velocity, w = m.base_velocity.head(3);
  const Vector<double> weight = moving_mass(c.robot) * c.sample.gravity;
  const Vector<double> turning = stacked(cross(w, momentum.head(3)), cross(w, momentum.tail(3)));
  const Vector<double> error = A * acceleration + change * velocity + turning - stacked(Vector<double>(3), weight);
  // Forces are rounded before they accelerate light links.
  const Vector<Real> forces = expected_accelerations(c, tau, gravity).terms;
  const Vector<Real> terms =
      magnitude(A.template cast<Real>()) * (magnitude(acceleration.template cast<Real>()) + 1e-3L * forces) +
      (magnitude(change) + speed * magnitude(A)).template cast<Real>() * magnitude(velocity.template cast<Real>());
  const auto worst = [&](int first) {
    return static_cast<Real>(largest(error.block(first, 0, 3, 1))) / largest(terms.block(first, 0, 3, 1));
  };
  checks.record("P3: free fall keeps the momentum", kDifference, worst_of({worst(0), worst(3)}), c.index);
}

template <class Subject>
void check_energies(const Subject& subject, const Case& c, Checks& checks) {
  const Motion<double>& m = c.sample.motion;
  const Vector<Real> velocity = coordinates(c.floating, c.motion.base_velocity, c.motion.qd);
  const Real kinetic_terms = dot(magnitude(velocity), magnitude(c.H) * magnitude(velocity)) / 2;
  if (kinetic_terms > 0) {
    const Real error = std::abs(subject.kinetic_energy(m) - kinetic_energy(c.robot, c.motion));
    checks.record("kinetic_energy", kEnergy, error / kinetic_terms, c.index);
  }
  const auto compare = [&](const char* name, const Arguments& arguments, const Vector<double>& gravity) {
    const Vector<Real> g = gravity.cast<Real>();
    const Real terms = 3 * largest(g) * center_length(c, 1);
    if (terms == 0) return;
    const Real error = std::abs(subject.potential_energy(m.q, arguments) - potential_energy(c.robot, c.motion.q, g));
    checks.record(name, kEnergy, error / terms, c.index);
  };
  compare("potential_energy", {}, {0, 0, -9.81});
  compare("potential_energy (gravity)", {&c.sample.gravity, nullptr}, c.sample.gravity);
}

// 1 rad/s and the speeds of all joints.
inline Real speed_of(const Case& c) {
  Real speed = 1;
  for (int j = 0; j < c.motion.qd.rows(); ++j) speed += std::abs(c.motion.qd(j));
  return speed;
}

// dH/dt, by differences.
inline Matrix<Real> rate_of_inertia(const Case& c) {
  const Real step = 1e-4L / speed_of(c);  // s: the longest chain rotates by 1e-4 rad at most
  const auto inertia = [&](Real steps) {
    Motion<Real> there;
    there.q = moved(c.robot, c.motion.q, steps * step * c.motion.qd);
    if (c.loops == nullptr || c.motion.of_loops.empty()) return joint_space_inertia(c.robot, there.q);
    there.qd = Vector<Real>(c.motion.qd.rows());
    const AtLoops loops = c.loops->near(there);
    Robot robot = loops.robot();
    robot.joints = c.robot.joints;  // the case may leave out their drives
    return joint_space_inertia(robot, there.q);
  };
  return 1 / (12 * step) * (Real(8) * (inertia(1) - inertia(-1)) - (inertia(2) - inertia(-2)));
}

// C v are the Coriolis forces, and dH/dt = C + C'.
template <class Subject>
void check_coriolis_matrix(const Subject& subject, const Case& c, Checks& checks, const std::string& of = "") {
  const Matrix<Real> C = subject.coriolis_matrix(c.sample.motion).template cast<Real>();
  const Vector<Real> velocity = coordinates(c.floating, c.motion.base_velocity, c.motion.qd);
  Motion<double> steady = at_rest(c.robot, c.sample.motion.q);
  steady.qd = c.sample.motion.qd;
  steady.base_velocity = c.sample.motion.base_velocity;
  steady.of_loops = c.sample.motion.of_loops;
  Expected forces = expected_forces(c, steady, without_passive<Real>(Vector<double>(3)));
  forces.terms += magnitude(C) * magnitude(velocity);
  checks.record(
      of + "coriolis_matrix times velocity", kForce, error_of(c, (C * velocity).template cast<double>(), forces),
      c.index);

  const Real speed = speed_of(c);
  const Matrix<Real> change = rate_of_inertia(c);
  const Matrix<Real> terms = magnitude(C) + magnitude(transpose(C)) + speed * inertia_magnitude(c);
  checks.record(of + "dH/dt - 2 C is skew symmetric", kSkew, relative_error(C + transpose(C), change, terms), c.index);
}

// p = H v, and its rate is dH/dt v less the bias forces.
template <class Subject>
void check_generalized_momentum(const Subject& subject, const Case& c, Checks& checks) {
  const Vector<Real> v = coordinates(c.floating, c.motion.base_velocity, c.motion.qd);
  const Matrix<Real> H_magnitude = inertia_magnitude(c);
  Motion<double> steady = at_rest(c.robot, c.sample.motion.q);
  steady.qd = c.sample.motion.qd;
  steady.base_velocity = c.sample.motion.base_velocity;
  steady.of_loops = c.sample.motion.of_loops;
  const auto compare = [&](const std::string& suffix, const Arguments& arguments, const Vector<double>& gravity) {
    const MomentumAndRate actual = subject.generalized_momentum(c.sample.motion, arguments);
    checks.record(
        "generalized_momentum" + suffix, kForce,
        error_of(c, actual.p, {joint_space_inertia(c.robot, c.motion.q) * v, H_magnitude * magnitude(v)}), c.index);
    Expected rate = expected_forces(c, steady, {gravity.cast<Real>(), {}});
    rate.value = rate_of_inertia(c) * v - rate.value;
    rate.terms += speed_of(c) * (H_magnitude * magnitude(v));
    checks.record("rate of generalized_momentum" + suffix, kSkew, error_of(c, actual.rate, rate), c.index);
  };
  compare("", {}, {0, 0, -9.81});
  compare(" (gravity)", {&c.sample.gravity, nullptr}, c.sample.gravity);
}

// The joint forces for a speed ds/dt and an acceleration dds/dt^2 along a path with the derivatives qd and qdd.
template <class Subject>
void check_path_dynamics(const Subject& subject, const Case& c, Checks& checks) {
  constexpr double kRate = 0.7, kRateOfRate = -1.3;
  const auto compare = [&](const std::string& suffix, const Arguments& arguments, const Vector<double>& gravity) {
    const PathTerms terms = subject.path_dynamics(c.sample.motion, arguments);
    Motion<double> motion = c.sample.motion;
    motion.qdd = kRateOfRate * motion.qd + kRate * kRate * motion.qdd;
    motion.qd = kRate * motion.qd;
    if (!motion.of_loops.empty()) motion.of_loops = kRate * kRate * motion.of_loops;
    const Vector<double> tau = kRateOfRate * terms.a + kRate * kRate * terms.b + terms.c;
    checks.record(
        "path_dynamics" + suffix, kForce, error_of(c, tau, expected_forces(c, motion, without_passive<Real>(gravity))),
        c.index);
  };
  compare("", {}, {0, 0, -9.81});
  compare(" (gravity)", {&c.sample.gravity, nullptr}, c.sample.gravity);
}

}  // namespace robcogen::reference
