// Checks of a compiled robot's dynamics: against the reference, and by identities that hold for every robot.
//
// Each function records the errors of one sample. `R` is the generated library's `Robot`.
#pragma once

#include "robcogen/reference/checks.h"
#include "robcogen/reference/compiled_robot.h"
#include "robcogen/reference/energy.h"
#include "robcogen/reference/samples.h"

namespace robcogen::reference {

inline constexpr Tolerance kForce{"kForce", 1e-10, "rounding of a sum over the robot, relative to the sum's terms"};
inline constexpr Tolerance kAcceleration{
    "kAcceleration", 1e-9, "rounding of the forces, carried to accelerations by the inverse of H"};
inline constexpr Tolerance kInertia{"kInertia", 1e-11, "rounding of a sum of positive terms"};
inline constexpr Tolerance kExact{"kExact", 0, "structural zeros and symmetry are exact"};
inline constexpr Tolerance kRoundTrip{"kRoundTrip", 1e-9, "forces to accelerations and back, two roundings"};
inline constexpr Tolerance kEnergy{"kEnergy", 1e-10, "rounding of sums over all links"};
inline constexpr Tolerance kDifference{
    "kDifference", 1e-7, "truncation and rounding of a fourth-order difference in double"};

// What the checks of one sample compare with; computed once.
struct Expected {
  Expected(const Robot& robot, const Sample& sample)
      : motion(cast<Real>(sample.motion)), H(joint_space_inertia(robot, motion.q)) {
    // Inertia matrices of documents with odd mass properties may be singular; then accelerations are not defined.
    const MatrixX<Real> inverse = H.size() == 0 ? H : MatrixX<Real>(H.partialPivLu().inverse());
    inverse_magnitude = inverse.cwiseAbs();
  }

  Motion<Real> motion;
  MatrixX<Real> H;
  MatrixX<Real> inverse_magnitude;
};

template <class R>
VectorX<Real> cut(const VectorX<Real>& base_and_joints) {
  return coordinates<Real>(
      R::kFloatingBase, base_and_joints.template head<6>(), base_and_joints.tail(base_and_joints.size() - 6));
}

// Base and joints apart, since their units differ.
inline Real blockwise_error(
    bool floating,
    const VectorX<double>& actual,
    const VectorX<Real>& expected,
    const VectorX<Real>& magnitude) {
  if (!floating) return relative_error(actual, expected, magnitude);
  const Eigen::Index n = actual.size() - 6;
  return std::max(
      {relative_error(actual.head<3>(), expected.head<3>(), magnitude.head<3>()),
       relative_error(actual.segment<3>(3), expected.segment<3>(3), magnitude.segment<3>(3)),
       relative_error(actual.tail(n), expected.tail(n), magnitude.tail(n))});
}

// Calls f(suffix, loads of the reference, optional arguments…) for each overload of a function.
template <class R, class Function>
void for_each_overload(const Sample& s, const Function& f) {
  using Compiled = CompiledRobot<R>;
  const Vector3<double> standard(0, 0, -9.81);
  const auto gravity = Compiled::gravity(s.gravity);
  const auto wrenches = Compiled::wrenches(s.external);
  f("", loads<Real>(standard));
  f(" (gravity)", loads<Real>(s.gravity), gravity);
  f(" (wrenches)", loads<Real>(standard, s.external), wrenches);
  f(" (gravity, wrenches)", loads<Real>(s.gravity, s.external), gravity, wrenches);
}

template <class R>
void check_inverse_dynamics(const Robot& robot, const Sample& s, const Expected& e, int sample, Checks& checks) {
  using Compiled = CompiledRobot<R>;
  for_each_overload<R>(s, [&](const std::string& suffix, const Loads<Real>& loads, const auto&... extra) {
    if constexpr (R::kFloatingBase) {
      const InverseDynamics<Real> free = inverse_dynamics(robot, e.motion, loads);
      Motion<Real> motion = e.motion;
      motion.base_acceleration = free.base_acceleration;
      const VectorX<Real> force = generalized_forces(robot, motion, loads).magnitude;
      const MatrixX<Real> composite_inverse = e.H.template topLeftCorner<6, 6>().partialPivLu().inverse();
      const VectorX<Real> acceleration = composite_inverse.cwiseAbs() * force.head<6>();
      VectorX<Real> magnitude(force.size());
      magnitude << acceleration,
          force.tail(s.motion.q.size()) + e.H.bottomLeftCorner(s.motion.q.size(), 6).cwiseAbs() * acceleration;
      const VectorX<Real> expected = coordinates<Real>(true, free.base_acceleration, free.tau);
      checks.record(
          "inverse_dynamics" + suffix, kForce,
          blockwise_error(true, Compiled::inverse_dynamics(s.motion, extra...), expected, magnitude), sample);
    }
    const GeneralizedForces<Real> forces = generalized_forces(robot, e.motion, loads);
    const char* name = R::kFloatingBase ? "inverse_dynamics_fully_actuated" : "inverse_dynamics";
    checks.record(
        name + suffix, kForce,
        blockwise_error(
            R::kFloatingBase, Compiled::fully_actuated(s.motion, extra...), cut<R>(forces.value),
            cut<R>(forces.magnitude)),
        sample);
  });
}

template <class R>
void check_bias_forces(const Robot& robot, const Sample& s, const Expected& e, int sample, Checks& checks) {
  using Compiled = CompiledRobot<R>;
  const auto compare = [&](const std::string& name, const VectorX<double>& actual, const Motion<Real>& motion,
                           const Loads<Real>& loads) {
    const GeneralizedForces<Real> forces = generalized_forces(robot, motion, loads);
    checks.record(
        name, kForce, blockwise_error(R::kFloatingBase, actual, cut<R>(forces.value), cut<R>(forces.magnitude)),
        sample);
  };
  const Motion<Real> rest = at_rest(e.motion.q);
  Motion<Real> steady = rest;
  steady.qd = e.motion.qd;
  steady.base_velocity = e.motion.base_velocity;
  for_each_overload<R>(s, [&](const std::string& suffix, const Loads<Real>& loads, const auto&... extra) {
    compare("bias_forces" + suffix, Compiled::bias_forces(s.motion, extra...), steady, loads);
  });
  compare("gravity_forces", Compiled::gravity_forces(s.motion), rest, Loads<Real>{});
  compare(
      "gravity_forces (gravity)", Compiled::gravity_forces(s.motion, Compiled::gravity(s.gravity)), rest,
      loads<Real>(s.gravity));
  compare("coriolis_forces", Compiled::coriolis_forces(s.motion), steady, loads<Real>(Vector3<double>::Zero()));
}

// Joint forces of the size that the sample's motion takes, so that accelerations stay moderate for light robots too.
inline VectorX<double> joint_forces(const Robot& robot, const Expected& e, const Loads<Real>& loads) {
  return inverse_dynamics(robot, e.motion, loads).tau.cast<double>();
}

template <class R>
void check_forward_dynamics(const Robot& robot, const Sample& s, const Expected& e, int sample, Checks& checks) {
  using Compiled = CompiledRobot<R>;
  for_each_overload<R>(s, [&](const std::string& suffix, const Loads<Real>& loads, const auto&... extra) {
    const VectorX<double> tau = joint_forces(robot, e, loads);
    const Accelerations<Real> result = forward_dynamics<Real>(robot, e.motion, tau.cast<Real>(), loads);
    Motion<Real> motion = e.motion;
    motion.qdd = result.qdd;
    motion.base_acceleration = result.base_acceleration;
    const GeneralizedForces<Real> forces = generalized_forces(robot, motion, loads);
    const VectorX<Real> expected = coordinates<Real>(R::kFloatingBase, result.base_acceleration, result.qdd);
    const VectorX<Real> magnitude = e.inverse_magnitude * cut<R>(forces.magnitude);
    const VectorX<double> actual = Compiled::forward_dynamics(s.motion, tau, extra...);
    checks.record(
        "forward_dynamics" + suffix, kAcceleration, blockwise_error(R::kFloatingBase, actual, expected, magnitude),
        sample);
  });
}

// Forces to accelerations and back, in the compiled library alone.
template <class R>
void check_round_trips(const Robot& robot, const Sample& s, const Expected& e, int sample, Checks& checks) {
  using Compiled = CompiledRobot<R>;
  const Eigen::Index n = s.motion.q.size();
  for_each_overload<R>(s, [&](const std::string& suffix, const Loads<Real>& loads, const auto&... extra) {
    const VectorX<double> forces = Compiled::inverse_dynamics(s.motion, extra...);
    const VectorX<double> tau = forces.tail(n);
    const VectorX<double> back = Compiled::forward_dynamics(s.motion, tau, extra...);
    VectorX<double> wanted = s.motion.qdd;
    Motion<Real> motion = e.motion;
    if constexpr (R::kFloatingBase) {
      wanted = coordinates<double>(true, forces.head<6>(), wanted);
      motion.base_acceleration = forces.template head<6>().template cast<Real>();
    }
    const VectorX<Real> magnitude = generalized_forces(robot, motion, loads).magnitude;
    checks.record(
        "P1: FD(ID(qdd)) = qdd" + suffix, kRoundTrip,
        blockwise_error(R::kFloatingBase, back, wanted.cast<Real>(), e.inverse_magnitude * cut<R>(magnitude)), sample);

    Motion<double> found = s.motion;
    found.qdd = back.tail(n);
    const VectorX<double> again = Compiled::inverse_dynamics(found, extra...);
    checks.record(
        "P1: ID(FD(tau)) = tau" + suffix, kRoundTrip, relative_error(again.tail(n), tau, magnitude.tail(n)), sample);
  });
}

// Whether motion of one joint carries the other.
inline bool on_one_branch(const Robot& robot, int a, int b) {
  const auto supports = [&](int joint, int other) {
    for (const int j : supporting_joints(robot, robot.joints[other].child)) {
      if (j == joint) return true;
    }
    return false;
  };
  return supports(a, b) || supports(b, a);
}

// An element of a positive definite matrix is at most the geometric mean of its diagonal elements.
inline MatrixX<Real> inertia_magnitude(const Expected& e) {
  const VectorX<Real> diagonal = e.H.diagonal().cwiseAbs().cwiseSqrt();
  return diagonal * diagonal.transpose();
}

template <class R>
void check_inertia_matrix(const Robot& robot, const Sample& s, const Expected& e, int sample, Checks& checks) {
  using Compiled = CompiledRobot<R>;
  const MatrixX<double> H = Compiled::joint_space_inertia(s.motion.q);
  const MatrixX<Real> magnitude = inertia_magnitude(e);
  checks.record("joint_space_inertia", kInertia, relative_error(H, e.H, magnitude), sample);
  checks.record("P2: H = H'", kExact, relative_error(H, H.transpose(), magnitude), sample);

  const int first = R::kFloatingBase ? 6 : 0;
  Real stray = 0;
  for (int a = 0; a < robot.joints.size; ++a) {
    for (int b = 0; b < robot.joints.size; ++b) {
      if (!on_one_branch(robot, a, b)) stray = std::max<Real>(stray, std::abs(H(first + a, first + b)));
    }
  }
  checks.record("P2: structural zeros of H", kExact, stray, sample);

  // Odd mass properties, which were warned of, make an indefinite matrix that is nevertheless right.
  if (H.size() != 0 && e.H.llt().info() == Eigen::Success)
    checks.record("P2: H positive definite", kExact, H.llt().info() == Eigen::Success ? 0 : 1, sample);

  const VectorX<double> velocity = coordinates<double>(R::kFloatingBase, s.motion.base_velocity, s.motion.qd);
  const Real energy = kinetic_energy(robot, e.motion);
  const Real terms = velocity.cwiseAbs().dot(H.cwiseAbs() * velocity.cwiseAbs()) / 2;
  if (terms != 0)
    checks.record(
        "P3: v'Hv/2 = kinetic energy", kEnergy, std::abs(velocity.dot(H * velocity) / 2 - energy) / terms, sample);
  if constexpr (R::kFloatingBase) {
    const VectorX<double> product = H.template topRows<6>() * velocity;
    const VectorX<double> sizes = H.template topRows<6>().cwiseAbs() * velocity.cwiseAbs();
    checks.record(
        "P3: base rows of Hv = momentum", kEnergy, relative_error(product, momentum(robot, e.motion), sizes), sample);
  }
}

template <class R>
void check_inertia_columns(const Sample& s, const Expected& e, int sample, Checks& checks) {
  using Compiled = CompiledRobot<R>;
  const int first = R::kFloatingBase ? 6 : 0;
  const Gravity none = Compiled::gravity(Vector3<double>::Zero());
  MatrixX<double> columns(e.H.rows(), e.H.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    Motion<double> unit = at_rest(s.motion.q);
    if (k < first) unit.base_acceleration(k) = 1;
    if (k >= first) unit.qdd(k - first) = 1;
    columns.col(k) = Compiled::fully_actuated(unit, none);
  }
  checks.record(
      "P2: columns of H = ID of unit accelerations", kInertia,
      relative_error(columns, Compiled::joint_space_inertia(s.motion.q), inertia_magnitude(e)), sample);
}

// dT/dt = v'(H v' + C) for T = v'Hv/2, so that 2 v'C = v'H'v: links Coriolis forces to the change of H in time.
template <class R>
void check_power(const Sample& s, int sample, Checks& checks) {
  using Compiled = CompiledRobot<R>;
  const double step = 1e-2 / (1 + s.motion.qd.cwiseAbs().sum());  // s; the whole chain turns by 0.01 rad
  const auto inertia = [&](double steps) -> MatrixX<double> {
    return Compiled::joint_space_inertia(s.motion.q + steps * step * s.motion.qd);
  };
  const MatrixX<double> change = (8 * (inertia(1) - inertia(-1)) - (inertia(2) - inertia(-2))) / (12 * step);
  const VectorX<double> velocity = coordinates<double>(R::kFloatingBase, s.motion.base_velocity, s.motion.qd);
  const VectorX<double> coriolis = Compiled::coriolis_forces(s.motion);
  const double terms = velocity.cwiseAbs().dot(
      coriolis.cwiseAbs() + change.cwiseAbs() * velocity.cwiseAbs() + inertia(0).cwiseAbs() * velocity.cwiseAbs());
  if (terms == 0) return;
  const double error = std::abs(velocity.dot(coriolis) - velocity.dot(change * velocity) / 2);
  checks.record("P3: v'C = v'(dH/dt)v/2", kDifference, error / terms, sample);
}

// The potential energy's slope along each joint, by a fourth-order difference.
template <class R>
void check_gravity_gradient(const Robot& robot, const Sample& s, const Expected& e, int sample, Checks& checks) {
  const Real step = 1e-3L;
  const Vector3<Real> gravity = s.gravity.cast<Real>();
  VectorX<Real> slope(robot.joints.size);
  for (int j = 0; j < robot.joints.size; ++j) {
    const auto energy = [&](Real steps) {
      VectorX<Real> q = e.motion.q;
      q(j) += steps * step;
      return potential_energy(robot, q, gravity);
    };
    slope(j) = (8 * (energy(1) - energy(-1)) - (energy(2) - energy(-2))) / (12 * step);
  }
  const VectorX<double> forces =
      CompiledRobot<R>::gravity_forces(s.motion, CompiledRobot<R>::gravity(s.gravity)).tail(robot.joints.size);
  const VectorX<Real> magnitude =
      generalized_forces(robot, at_rest(e.motion.q), loads<Real>(s.gravity)).magnitude.tail(robot.joints.size);
  checks.record(
      "P3: gravity_forces = gradient of potential energy", kDifference, relative_error(forces, slope, magnitude),
      sample);
}

}  // namespace robcogen::reference
