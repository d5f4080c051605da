// Dynamics of an articulated robot: Newton's and Euler's equations of every body about its centre of mass, in base
// coordinates, projected onto the generalised coordinates by the transposed Jacobians.
//
//     H(q) (base acceleration, qdd) + bias = (base wrench, tau)
//
// with the full (6 + n) x (6 + n) matrix also for a fixed base, whose first six coordinates are then cut away.
// Conventions: 6D vectors are angular first; base quantities are in base coordinates about the base origin; gravity is
// in base coordinates (m/s^2); external wrenches act on links, in link coordinates about the link frame's origin.
#pragma once

#include "robcogen/reference/kinematics.h"

namespace robcogen::reference {

template <class Scalar>
struct Loads {
  Vector3<Scalar> gravity = Vector3<Scalar>(Scalar(0), Scalar(0), Scalar(-9.81));
  std::vector<Vector6<Scalar>> external;  // one for each link, base first; empty: none
};

template <class Scalar>
struct Forces {
  VectorX<Scalar> tau;
  Vector6<Scalar> base_wrench;  // what has to act on the base; for a fixed base, what its support exerts
};

template <class Scalar>
struct Accelerations {
  VectorX<Scalar> qdd;
  Vector6<Scalar> base_acceleration;  // zero for a fixed base
};

template <class Scalar>
struct InverseDynamics {
  VectorX<Scalar> tau;
  Vector6<Scalar> base_acceleration;  // zero for a fixed base
};

template <class Scalar>
Vector3<Scalar> center_of_mass(const reflection::Link& link) {
  return Vector3<Scalar>(Scalar(link.com[0]), Scalar(link.com[1]), Scalar(link.com[2]));
}

// Rotational inertia about the centre of mass, link axes: Steiner's theorem from the link frame's origin.
template <class Scalar>
Matrix3<Scalar> central_inertia(const reflection::Link& link) {
  const double(&I)[6] = link.inertia;
  Matrix3<Scalar> about_origin;
  about_origin << Scalar(I[0]), Scalar(-I[3]), Scalar(-I[4]),  //
      Scalar(-I[3]), Scalar(I[1]), Scalar(-I[5]),              //
      Scalar(-I[4]), Scalar(-I[5]), Scalar(I[2]);
  const Vector3<Scalar> c = center_of_mass<Scalar>(link);
  return about_origin - Scalar(link.mass) * (c.squaredNorm() * Matrix3<Scalar>::Identity() - c * c.transpose());
}

// The 6 x 6 inertia of a link for (angular velocity, velocity of the centre of mass) in base axes.
template <class Scalar>
Matrix6<Scalar> body_inertia(const reflection::Link& link, const Matrix4<Scalar>& pose) {
  Matrix6<Scalar> M = Matrix6<Scalar>::Zero();
  M.template topLeftCorner<3, 3>() = rotation_of(pose) * central_inertia<Scalar>(link) * rotation_of(pose).transpose();
  M.template bottomRightCorner<3, 3>() = Scalar(link.mass) * Matrix3<Scalar>::Identity();
  return M;
}

// (6 + n) x (6 + n), base first.
template <class Scalar>
MatrixX<Scalar> full_inertia(const Robot& robot, const VectorX<Scalar>& q) {
  const std::vector<Matrix4<Scalar>> poses = link_poses(robot, q);
  MatrixX<Scalar> H = MatrixX<Scalar>::Zero(6 + q.size(), 6 + q.size());
  for (int i = 0; i < robot.links.size; ++i) {
    const Matrix6X<Scalar> J = body_jacobian<Scalar>(robot, poses, i, center_of_mass<Scalar>(robot.links[i]));
    H += J.transpose() * body_inertia(robot.links[i], poses[static_cast<std::size_t>(i)]) * J;
  }
  return H;
}

// n x n, or (6 + n) x (6 + n), base first, for a floating base.
template <class Scalar>
MatrixX<Scalar> joint_space_inertia(const Robot& robot, const VectorX<Scalar>& q) {
  const MatrixX<Scalar> H = full_inertia(robot, q);
  return robot.floating_base ? H : MatrixX<Scalar>(H.bottomRightCorner(q.size(), q.size()));
}

// An external wrench of a link, taken to the link's centre of mass and to base axes.
template <class Scalar>
Vector6<Scalar> wrench_at_center_of_mass(
    const reflection::Link& link,
    const Matrix4<Scalar>& pose,
    const Vector6<Scalar>& wrench) {
  const Vector3<Scalar> moment = wrench.template head<3>();
  const Vector3<Scalar> force = wrench.template tail<3>();
  const Matrix3<Scalar> R = rotation_of(pose);
  Vector6<Scalar> result;
  result << R * (moment - center_of_mass<Scalar>(link).cross(force)), R * force;
  return result;
}

// The wrench that all constraints and actuators together exert on a link, at its centre of mass, in base axes; and the
// sum of the magnitudes of the terms that make it up.
template <class Scalar>
struct BodyWrench {
  Vector6<Scalar> value;
  Vector6<Scalar> magnitude;
};

template <class Scalar>
BodyWrench<Scalar> required_wrench(
    const Robot& robot,
    int link,
    const LinkMotion<Scalar>& motion,
    const Loads<Scalar>& loads) {
  const reflection::Link& body = robot.links[link];
  const Matrix3<Scalar> R = rotation_of(motion.pose);
  const Matrix3<Scalar> inertia = R * central_inertia<Scalar>(body) * R.transpose();
  const Vector3<Scalar> w = motion.angular_velocity();
  const Vector3<Scalar> spin = inertia * motion.angular_acceleration();
  const Vector3<Scalar> gyroscopic = w.cross(Vector3<Scalar>(inertia * w));
  const Vector3<Scalar> inertial = Scalar(body.mass) * motion.acceleration(center_of_mass<Scalar>(body));
  const Vector3<Scalar> weight = Scalar(body.mass) * loads.gravity;
  Vector6<Scalar> external = Vector6<Scalar>::Zero();
  if (!loads.external.empty())
    external = wrench_at_center_of_mass(body, motion.pose, loads.external[static_cast<std::size_t>(link)]);

  BodyWrench<Scalar> result;
  result.value << spin + gyroscopic, inertial - weight;
  result.value -= external;
  result.magnitude << spin.cwiseAbs() + gyroscopic.cwiseAbs(), inertial.cwiseAbs() + weight.cwiseAbs();
  result.magnitude += external.cwiseAbs();
  return result;
}

// Generalised forces (base wrench, tau) of a motion, and the sum of the magnitudes of what adds up to each: the
// yardstick for its rounding errors.
template <class Scalar>
struct GeneralizedForces {
  VectorX<Scalar> value;
  VectorX<Scalar> magnitude;
};

template <class Scalar>
GeneralizedForces<Scalar> generalized_forces(
    const Robot& robot,
    const Motion<Scalar>& motion,
    const Loads<Scalar>& loads) {
  const std::vector<LinkMotion<Scalar>> links = link_motions(robot, motion);
  const std::vector<Matrix4<Scalar>> poses = link_poses(robot, motion.q);
  const Eigen::Index size = 6 + motion.q.size();
  GeneralizedForces<Scalar> forces{VectorX<Scalar>::Zero(size), VectorX<Scalar>::Zero(size)};
  for (int i = 0; i < robot.links.size; ++i) {
    const BodyWrench<Scalar> wrench = required_wrench(robot, i, links[static_cast<std::size_t>(i)], loads);
    const Matrix6X<Scalar> J = body_jacobian<Scalar>(robot, poses, i, center_of_mass<Scalar>(robot.links[i]));
    forces.value += J.transpose() * wrench.value;
    forces.magnitude += J.cwiseAbs().transpose() * wrench.magnitude;
  }
  return forces;
}

template <class Scalar>
Forces<Scalar> split(const VectorX<Scalar>& generalized) {
  return {generalized.tail(generalized.size() - 6), generalized.template head<6>()};
}

// Joint forces and base wrench for a given motion, base acceleration included.
template <class Scalar>
Forces<Scalar> inverse_dynamics_fully_actuated(
    const Robot& robot,
    const Motion<Scalar>& motion,
    const Loads<Scalar>& loads) {
  return split(generalized_forces(robot, motion, loads).value);
}

// Joint forces for given joint accelerations. A floating base is free: its acceleration follows, and what `motion` says
// of it is ignored.
template <class Scalar>
InverseDynamics<Scalar> inverse_dynamics(const Robot& robot, Motion<Scalar> motion, const Loads<Scalar>& loads) {
  motion.base_acceleration.setZero();
  if (robot.floating_base) {
    const Vector6<Scalar> wrench = generalized_forces(robot, motion, loads).value.template head<6>();
    const Matrix6<Scalar> composite = full_inertia(robot, motion.q).template topLeftCorner<6, 6>();
    motion.base_acceleration = -composite.partialPivLu().solve(wrench);
  }
  return {inverse_dynamics_fully_actuated(robot, motion, loads).tau, motion.base_acceleration};
}

// Joint forces and base wrench of a motion with all accelerations zero: gravity, Coriolis, centripetal and external.
// The accelerations of `motion` are ignored.
template <class Scalar>
Forces<Scalar> bias_forces(const Robot& robot, Motion<Scalar> motion, const Loads<Scalar>& loads) {
  motion.qdd.setZero(motion.q.size());
  motion.base_acceleration.setZero();
  return split(generalized_forces(robot, motion, loads).value);
}

// Joint forces and base wrench that hold the robot still; no external wrenches.
template <class Scalar>
Forces<Scalar> gravity_forces(const Robot& robot, const VectorX<Scalar>& q, const Vector3<Scalar>& gravity) {
  return split(generalized_forces(robot, at_rest(q), Loads<Scalar>{gravity, {}}).value);
}

// Bias forces without gravity and external wrenches.
template <class Scalar>
Forces<Scalar> coriolis_forces(const Robot& robot, const Motion<Scalar>& motion) {
  return bias_forces(robot, motion, Loads<Scalar>{Vector3<Scalar>::Zero(), {}});
}

// Accelerations for given joint forces, by a dense solve; a floating base carries no wrench but the external one. The
// accelerations of `motion` are ignored.
template <class Scalar>
Accelerations<Scalar> forward_dynamics(
    const Robot& robot,
    const Motion<Scalar>& motion,
    const VectorX<Scalar>& tau,
    const Loads<Scalar>& loads) {
  const Forces<Scalar> bias = bias_forces(robot, motion, loads);
  // Pivoted LU, not Cholesky: documents with indefinite inertias exist and still define accelerations.
  const auto solve = [](const MatrixX<Scalar>& H, const VectorX<Scalar>& b) -> VectorX<Scalar> {
    return b.size() == 0 ? b : VectorX<Scalar>(H.partialPivLu().solve(b));
  };
  const MatrixX<Scalar> H = joint_space_inertia(robot, motion.q);
  if (!robot.floating_base) return {solve(H, tau - bias.tau), Vector6<Scalar>::Zero()};
  VectorX<Scalar> right(6 + tau.size());
  right << -bias.base_wrench, tau - bias.tau;
  const VectorX<Scalar> result = solve(H, right);
  return {result.tail(tau.size()), result.template head<6>()};
}

}  // namespace robcogen::reference
