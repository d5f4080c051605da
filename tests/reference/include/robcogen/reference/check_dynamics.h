// Checks of a robot's dynamics against the reference. Each function records the errors of one sample.
#pragma once

#include "robcogen/reference/checks.h"
#include "robcogen/reference/rounding.h"
#include "robcogen/reference/samples.h"
#include "robcogen/reference/subject.h"

namespace robcogen::reference {

inline constexpr Tolerance kForce{"kForce", 1e-12, "rounding of a sum over the robot, relative to the sum's terms"};
inline constexpr Tolerance kAcceleration{
    "kAcceleration", 1e-11, "rounding of the forces, carried to accelerations by the inverse of H"};
inline constexpr Tolerance kInertia{"kInertia", 1e-12, "rounding of a sum of positive terms"};

class AtLoops;

// A sample, and the reference of all its checks.
struct Case {
  // `at_loops` belongs to the robot; nullptr if the robot has no loops.
  Case(const Robot& tables, const Sample& random, int number, const AtLoops* at_loops = nullptr)
      : robot(tables),
        loops(at_loops),
        sample(random),
        index(number),
        floating(tables.floating_base),
        motion(cast<Real>(random.motion)),
        H(joint_space_inertia(tables, motion.q)),
        inverse_magnitude(magnitude(solve(H, Matrix<Real>::identity(H.rows())))) {}

  const Robot& robot;
  const AtLoops* loops;
  const Sample& sample;
  int index;
  bool floating;
  Motion<Real> motion;
  Matrix<Real> H;
  Matrix<Real> inverse_magnitude;
};

// Cuts a vector of all 6 + n coordinates to those of the robot: all of them for a floating base, else the last n.
inline Vector<Real> cut(bool floating, const Vector<Real>& base_and_joints) {
  return floating ? base_and_joints : base_and_joints.tail(base_and_joints.rows() - 6);
}

// Base and joints are judged separately, and so are angular and linear parts, because their units differ.
inline Real blockwise_error(
    bool floating,
    const Vector<double>& actual,
    const Vector<Real>& expected,
    const Vector<Real>& terms) {
  const Vector<Real> found = actual.cast<Real>();
  if (!floating) return relative_error(found, expected, terms);
  const auto error = [&](int first, int size) {
    return relative_error(
        found.block(first, 0, size, 1), expected.block(first, 0, size, 1), terms.block(first, 0, size, 1));
  };
  return worst_of({error(0, 3), error(3, 3), error(6, actual.rows() - 6)});
}

// One overload of a function: its arguments, and the loads that they stand for.
struct Overload {
  std::string suffix;
  Arguments arguments;
  Loads<Real> loads;
};

// The arguments are pointers into the sample.
inline std::vector<Overload> overloads(const Sample& s) {
  const Vector<double> standard{0, 0, -9.81};
  return {
      {"", {}, loads<Real>(standard)},
      {" (gravity)", {&s.gravity, nullptr}, loads<Real>(s.gravity)},
      {" (wrenches)", {nullptr, &s.external}, loads<Real>(standard, s.external)},
      {" (gravity, wrenches)", {&s.gravity, &s.external}, loads<Real>(s.gravity, s.external)}};
}

// A result, and the sizes of the terms that its elements sum.
struct Expected {
  Vector<Real> value;
  Vector<Real> terms;
};

// (base wrench, tau), or tau.
inline Expected expected_forces(const Case& c, const Motion<double>& motion, const Loads<Real>& loads) {
  const Vector<Real> value = generalized_forces(c.robot, cast<Real>(motion), loads);
  const Vector<Real> terms = force_terms(c.robot, motion, loads.cast<double>()).cast<Real>();
  return {cut(c.floating, value), cut(c.floating, terms)};
}

// Base acceleration and joint forces with a free base.
inline Expected expected_free_motion(const Case& c, const Loads<Real>& loads) {
  const InverseDynamics<Real> free = inverse_dynamics(c.robot, c.motion, loads);
  Motion<double> motion = c.sample.motion;
  motion.base_acceleration = free.base_acceleration.cast<double>();
  const Vector<Real> force = expected_forces(c, motion, loads).terms;
  const int n = c.robot.dof();
  const Matrix<Real> composite = c.H.block(0, 0, 6, 6);
  const Vector<Real> acceleration = magnitude(solve(composite, Matrix<Real>::identity(6))) * force.head(6);
  const Vector<Real> joints = force.tail(n) + magnitude(c.H.block(6, 0, n, 6)) * acceleration;
  return {stacked(free.base_acceleration, free.tau), stacked(acceleration, joints)};
}

// (base acceleration, qdd), or qdd.
inline Expected expected_accelerations(const Case& c, const Vector<double>& tau, const Loads<Real>& loads) {
  const Accelerations<Real> result = forward_dynamics(c.robot, c.motion, tau.cast<Real>(), loads);
  Motion<double> motion = c.sample.motion;
  motion.qdd = result.qdd.cast<double>();
  motion.base_acceleration = result.base_acceleration.cast<double>();
  return {
      coordinates(c.floating, result.base_acceleration, result.qdd),
      c.inverse_magnitude * expected_forces(c, motion, loads).terms};
}

inline Real error_of(const Case& c, const Vector<double>& actual, const Expected& expected) {
  return blockwise_error(c.floating, actual, expected.value, expected.terms);
}

template <class Subject>
void check_inverse_dynamics(const Subject& subject, const Case& c, Checks& checks) {
  const Motion<double>& motion = c.sample.motion;
  for (const Overload& o : overloads(c.sample)) {
    if (c.floating)
      checks.record(
          "inverse_dynamics" + o.suffix, kForce,
          error_of(c, subject.inverse_dynamics(motion, o.arguments), expected_free_motion(c, o.loads)), c.index);
    checks.record(
        (c.floating ? "inverse_dynamics_fully_actuated" : "inverse_dynamics") + o.suffix, kForce,
        error_of(c, subject.inverse_dynamics_fully_actuated(motion, o.arguments), expected_forces(c, motion, o.loads)),
        c.index);
  }
}

template <class Subject>
void check_bias_forces(const Subject& subject, const Case& c, Checks& checks) {
  const Sample& s = c.sample;
  const Motion<double> rest = at_rest(c.robot, s.motion.q);
  Motion<double> steady = rest;
  steady.qd = s.motion.qd;
  steady.base_velocity = s.motion.base_velocity;
  steady.of_loops = s.motion.of_loops;
  const auto compare = [&](const std::string& name, const Vector<double>& actual, const Motion<double>& motion,
                           const Loads<Real>& loads) {
    checks.record(name, kForce, error_of(c, actual, expected_forces(c, motion, loads)), c.index);
  };
  for (const Overload& o : overloads(s))
    compare("bias_forces" + o.suffix, subject.bias_forces(s.motion, o.arguments), steady, o.loads);
  const Arguments gravity{&s.gravity, nullptr};
  const Vector<double> standard{0, 0, -9.81};
  compare("gravity_forces", subject.gravity_forces(s.motion.q, {}), rest, without_passive<Real>(standard));
  compare(
      "gravity_forces (gravity)", subject.gravity_forces(s.motion.q, gravity), rest, without_passive<Real>(s.gravity));
  compare("coriolis_forces", subject.coriolis_forces(s.motion), steady, without_passive<Real>(Vector<double>(3)));
}

// Includes friction, whose direction is uncertain only where the velocity is within rounding of zero.
template <class Subject>
void check_passive_forces(const Subject& subject, const Case& c, Checks& checks) {
  Motion<double> rest = c.sample.motion;
  rest.qd = Vector<double>(c.robot.dof());
  const auto compare = [&](const char* name, const Motion<double>& motion) {
    const Vector<Real> expected = passive_forces(c.robot, cast<Real>(motion));
    const Vector<Real> terms = force_terms(c.robot, motion, {}).tail(c.robot.dof()).template cast<Real>();
    checks.record(
        name, kForce, relative_error(subject.passive_forces(motion).template cast<Real>(), expected, terms), c.index);
  };
  compare("passive_forces", c.sample.motion);
  compare("passive_forces (at rest)", rest);
}

template <class Subject>
void check_forward_dynamics(const Subject& subject, const Case& c, Checks& checks) {
  for (const Overload& o : overloads(c.sample)) {
    // The joint forces are those of the sample's motion, so that accelerations stay moderate for light robots, too.
    const Vector<double> tau = inverse_dynamics(c.robot, c.motion, o.loads).tau.cast<double>();
    const Vector<double> actual = subject.forward_dynamics(c.sample.motion, tau, o.arguments);
    checks.record(
        "forward_dynamics" + o.suffix, kAcceleration, error_of(c, actual, expected_accelerations(c, tau, o.loads)),
        c.index);
  }
}

// Upper bounds of the elements of H: an element of a positive definite matrix is at most the geometric mean of its
// diagonal elements.
inline Matrix<Real> inertia_magnitude(const Case& c) {
  Vector<Real> diagonal(c.H.rows());
  for (int i = 0; i < c.H.rows(); ++i) diagonal(i) = std::sqrt(std::abs(c.H(i, i)));
  return diagonal * transpose(diagonal);
}

template <class Subject>
void check_inertia_matrix(const Subject& subject, const Case& c, Checks& checks) {
  const Matrix<double> H = subject.joint_space_inertia(c.sample.motion.q);
  checks.record("joint_space_inertia", kInertia, relative_error(H.cast<Real>(), c.H, inertia_magnitude(c)), c.index);
}

}  // namespace robcogen::reference
