// Dynamics of an articulated robot: Newton's and Euler's equations of every body about its centre of mass, in base
// coordinates, projected onto the generalised coordinates by the transposed Jacobians.
//
//     H(q) (base acceleration, qdd) + bias = (base wrench, tau)
//
// with the full (6 + n) x (6 + n) matrix also for a fixed base, whose first six coordinates are then cut away.
// Conventions: 6D vectors are angular first; base quantities are in base coordinates about the base origin; gravity is
// in base coordinates (m/s^2); external wrenches act on links, in link coordinates about the link frame's origin.
#pragma once

#include "robcogen/reference/drives.h"
#include "robcogen/reference/kinematics.h"

namespace robcogen::reference {

template <class Scalar>
struct Loads {
  Vector<Scalar> gravity = {Scalar(0), Scalar(0), Scalar(-9.81)};
  std::vector<Vector<Scalar>> external;  // one for each link, base first; empty: none
  bool passive = true;                   // the joints overcome the passive forces of their drives

  template <class Other>
  Loads<Other> cast() const {
    Loads<Other> result{gravity.template cast<Other>(), {}, passive};
    for (const Vector<Scalar>& wrench : external) result.external.push_back(wrench.template cast<Other>());
    return result;
  }
};

template <class Scalar>
struct Forces {
  Vector<Scalar> tau;
  Vector<Scalar> base_wrench;  // the wrench on the base; for a fixed base, that of its support
};

template <class Scalar>
struct Accelerations {
  Vector<Scalar> qdd;
  Vector<Scalar> base_acceleration;  // zero for a fixed base
};

template <class Scalar>
struct InverseDynamics {
  Vector<Scalar> tau;
  Vector<Scalar> base_acceleration;  // zero for a fixed base
};

template <class Scalar>
Vector<Scalar> center_of_mass(const reflection::Link& link) {
  return {Scalar(link.com[0]), Scalar(link.com[1]), Scalar(link.com[2])};
}

// Rotational inertia about the centre of mass, in link axes: parallel axis (Steiner's) theorem from the link frame's
// origin.
template <class Scalar>
Matrix<Scalar> central_inertia(const reflection::Link& link) {
  const auto [xx, yy, zz, xy, xz, yz] = link.inertia;
  Matrix<Scalar> about_origin(3, 3);
  about_origin(0, 0) = Scalar(xx);
  about_origin(1, 1) = Scalar(yy);
  about_origin(2, 2) = Scalar(zz);
  about_origin(0, 1) = about_origin(1, 0) = Scalar(-xy);
  about_origin(0, 2) = about_origin(2, 0) = Scalar(-xz);
  about_origin(1, 2) = about_origin(2, 1) = Scalar(-yz);
  const Vector<Scalar> c = center_of_mass<Scalar>(link);
  return about_origin - Scalar(link.mass) * (dot(c, c) * Matrix<Scalar>::identity(3) - c * transpose(c));
}

// Adds J' M J, for the columns of J that are not zero: those of the coordinates that move the body.
template <class Scalar>
void add_body(const Matrix<Scalar>& J, const Matrix<Scalar>& M, Matrix<Scalar>& H) {
  std::vector<int> moving;
  for (int j = 0; j < J.cols(); ++j)
    if (largest(J.col(j)) != Scalar(0)) moving.push_back(j);
  Matrix<Scalar> columns(6, static_cast<int>(moving.size()));
  for (int k = 0; k < columns.cols(); ++k) columns.set_block(0, k, J.col(moving[static_cast<std::size_t>(k)]));
  const Matrix<Scalar> added = transpose(columns) * (M * columns);
  for (int b = 0; b < columns.cols(); ++b)
    for (int a = 0; a < columns.cols(); ++a)
      H(moving[static_cast<std::size_t>(a)], moving[static_cast<std::size_t>(b)]) += added(a, b);
}

// (6 + n) x (6 + n), base first.
template <class Scalar>
Matrix<Scalar> full_inertia(const Robot& robot, const Vector<Scalar>& q) {
  const std::vector<Matrix<Scalar>> poses = link_poses(robot, q);
  Matrix<Scalar> H(6 + robot.dof(), 6 + robot.dof());
  for (int i = 0; i < robot.links.size; ++i) {
    const reflection::Link& link = robot.links[i];
    const Matrix<Scalar> R = rotation_of(poses[static_cast<std::size_t>(i)]);
    Matrix<Scalar> M(6, 6);
    M.set_block(0, 0, R * central_inertia<Scalar>(link) * transpose(R));
    M.set_block(3, 3, Scalar(link.mass) * Matrix<Scalar>::identity(3));
    add_body(body_jacobian(robot, poses, i, center_of_mass<Scalar>(link)), M, H);
  }
  add_drives(robot, poses, H);
  return H;
}

// n x n, or (6 + n) x (6 + n), base first, for a floating base.
template <class Scalar>
Matrix<Scalar> joint_space_inertia(const Robot& robot, const Vector<Scalar>& q) {
  const Matrix<Scalar> H = full_inertia(robot, q);
  return robot.floating_base ? H : H.block(6, 6, robot.dof(), robot.dof());
}

// An external wrench of a link, moved to the link's centre of mass and to base axes.
template <class Scalar>
Vector<Scalar> wrench_at_center_of_mass(
    const reflection::Link& link,
    const Matrix<Scalar>& pose,
    const Vector<Scalar>& wrench) {
  const Matrix<Scalar> R = rotation_of(pose);
  const Vector<Scalar> force = wrench.tail(3);
  return stacked(R * (wrench.head(3) - cross(center_of_mass<Scalar>(link), force)), R * force);
}

// The wrench that all constraints and actuators together exert on a link, at its centre of mass, in base axes.
template <class Scalar>
Vector<Scalar> required_wrench(
    const Robot& robot,
    int link,
    const LinkMotion<Scalar>& motion,
    const Loads<Scalar>& loads) {
  const reflection::Link& body = robot.links[link];
  const Matrix<Scalar> R = rotation_of(motion.pose);
  const Matrix<Scalar> inertia = R * central_inertia<Scalar>(body) * transpose(R);
  const Vector<Scalar> w = motion.angular_velocity();
  const Vector<Scalar> moment = inertia * motion.angular_acceleration() + cross(w, inertia * w);
  const Vector<Scalar> force = Scalar(body.mass) * (motion.acceleration(center_of_mass<Scalar>(body)) - loads.gravity);
  if (loads.external.empty()) return stacked(moment, force);
  const Vector<Scalar>& external = loads.external[static_cast<std::size_t>(link)];
  return stacked(moment, force) - wrench_at_center_of_mass(body, motion.pose, external);
}

// (base wrench, tau) of a motion.
template <class Scalar>
Vector<Scalar> generalized_forces(const Robot& robot, const Motion<Scalar>& motion, const Loads<Scalar>& loads) {
  const std::vector<LinkMotion<Scalar>> links = link_motions(robot, motion);
  std::vector<Matrix<Scalar>> poses;
  for (const LinkMotion<Scalar>& link : links) poses.push_back(link.pose);
  Vector<Scalar> forces(6 + robot.dof());
  for (int i = 0; i < robot.links.size; ++i) {
    const Matrix<Scalar> J = body_jacobian(robot, poses, i, center_of_mass<Scalar>(robot.links[i]));
    forces += transpose(J) * required_wrench(robot, i, links[static_cast<std::size_t>(i)], loads);
  }
  forces += forces_on_drives(robot, motion, links, poses);
  if (loads.passive) forces += stacked(Vector<Scalar>(6), passive_forces_of_dynamics(robot, motion));
  return forces;
}

template <class Scalar>
Forces<Scalar> split(const Vector<Scalar>& generalized) {
  return {generalized.tail(generalized.rows() - 6), generalized.head(6)};
}

// Joint forces and base wrench for a given motion, base acceleration included.
template <class Scalar>
Forces<Scalar> inverse_dynamics_fully_actuated(
    const Robot& robot,
    const Motion<Scalar>& motion,
    const Loads<Scalar>& loads) {
  return split(generalized_forces(robot, motion, loads));
}

// Joint forces for given joint accelerations. A floating base is free: its acceleration is a result, and the one in
// `motion` is ignored.
template <class Scalar>
InverseDynamics<Scalar> inverse_dynamics(const Robot& robot, Motion<Scalar> motion, const Loads<Scalar>& loads) {
  motion.base_acceleration = Vector<Scalar>(6);
  if (robot.floating_base) {
    const Vector<Scalar> wrench = generalized_forces(robot, motion, loads).head(6);
    const Matrix<Scalar> composite = full_inertia(robot, motion.q).block(0, 0, 6, 6);
    motion.base_acceleration = -solve(composite, wrench);
  }
  return {inverse_dynamics_fully_actuated(robot, motion, loads).tau, motion.base_acceleration};
}

// Joint forces and base wrench of a motion with all accelerations zero: gravity, Coriolis, centripetal and external.
// The accelerations of `motion` are ignored.
template <class Scalar>
Forces<Scalar> bias_forces(const Robot& robot, Motion<Scalar> motion, const Loads<Scalar>& loads) {
  motion.qdd = Vector<Scalar>(robot.dof());
  motion.base_acceleration = Vector<Scalar>(6);
  return split(generalized_forces(robot, motion, loads));
}

// Joint forces and base wrench that hold the robot still against gravity, without external wrenches and passive forces.
template <class Scalar>
Forces<Scalar> gravity_forces(const Robot& robot, const Vector<Scalar>& q, const Vector<Scalar>& gravity) {
  return bias_forces(robot, at_rest(robot, q), {gravity, {}, false});
}

// Bias forces without gravity, external wrenches and passive forces.
template <class Scalar>
Forces<Scalar> coriolis_forces(const Robot& robot, const Motion<Scalar>& motion) {
  return bias_forces(robot, motion, {Vector<Scalar>(3), {}, false});
}

// Accelerations for given joint forces, by a dense solve; only external wrenches act on a floating base. The
// accelerations of `motion` are ignored.
template <class Scalar>
Accelerations<Scalar> forward_dynamics(
    const Robot& robot,
    const Motion<Scalar>& motion,
    const Vector<Scalar>& tau,
    const Loads<Scalar>& loads) {
  const Forces<Scalar> bias = bias_forces(robot, motion, loads);
  const Matrix<Scalar> H = joint_space_inertia(robot, motion.q);
  if (!robot.floating_base) return {solve(H, tau - bias.tau), Vector<Scalar>(6)};
  const Vector<Scalar> result = solve(H, stacked(-bias.base_wrench, tau - bias.tau));
  return {result.tail(tau.rows()), result.head(6)};
}

}  // namespace robcogen::reference
