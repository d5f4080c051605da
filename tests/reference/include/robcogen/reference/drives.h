// Drives of joints: their inertia, rotors that spin on links, and the forces with which they resist motion.
//
// The mass properties of a link that carries a rotor include the rotor, as if it were fixed. Its spin adds the
// momentum J N qd about the rotor's axis, which moves with the carrier.
#pragma once

#include "robcogen/reference/kinematics.h"

namespace robcogen::reference {

// How the base and the elements of q move a joint: its row of [1 0; 0 G].
template <class Scalar>
Vector<Scalar> row_of_joint(const Robot& robot, int joint) {
  Vector<Scalar> row(6 + robot.dof());
  for (const Mover& mover : movers_of(robot, joint)) row(6 + mover.coordinate) = Scalar(mover.factor);
  return row;
}

// The axis of the rotor in base axes; zero without a rotor.
template <class Scalar>
Vector<Scalar> rotor_axis(const JointDrive& drive, const Matrix<Scalar>& carrier_pose) {
  const auto [x, y, z] = drive.rotor_axis;
  return rotation_of(carrier_pose) * Vector<Scalar>{Scalar(x), Scalar(y), Scalar(z)};
}

template <class Scalar>
Scalar inertia_of(const JointDrive& drive) {
  const Scalar ratio(drive.rotor_ratio);
  return Scalar(drive.armature) + Scalar(drive.rotor_inertia) * ratio * ratio;
}

inline bool has_inertia(const JointDrive& drive) {
  return drive.armature != 0 || drive.rotor_inertia != 0;
}

// Momentum of the rotor in its carrier, per unit rate of the joint.
template <class Scalar>
Scalar momentum_of_rotor(const JointDrive& drive) {
  return Scalar(drive.rotor_inertia) * Scalar(drive.rotor_ratio);
}

// Adds the inertia of the drives to the (6 + n) x (6 + n) matrix.
template <class Scalar>
void add_drives(const Robot& robot, const std::vector<Matrix<Scalar>>& poses, Matrix<Scalar>& H) {
  for (int j = 0; j < robot.joints.size; ++j) {
    const JointDrive& drive = robot.joints[j].drive;
    if (!has_inertia(drive)) continue;
    const Vector<Scalar> row = row_of_joint<Scalar>(robot, j);
    H += inertia_of<Scalar>(drive) * (row * transpose(row));
    if (drive.rotor_carrier < 0) continue;
    const Matrix<Scalar>& carrier = poses[static_cast<std::size_t>(drive.rotor_carrier)];
    const Matrix<Scalar> turning =
        body_jacobian(robot, poses, drive.rotor_carrier, Vector<Scalar>(3)).block(0, 0, 3, 6 + robot.dof());
    const Vector<Scalar> spin = momentum_of_rotor<Scalar>(drive) * rotor_axis(drive, carrier);
    const Vector<Scalar> coupling = transpose(turning) * spin;
    H += row * transpose(coupling) + coupling * transpose(row);
  }
}

// The contribution of the drives' inertia to (base wrench, tau).
template <class Scalar>
Vector<Scalar> forces_on_drives(
    const Robot& robot,
    const Motion<Scalar>& motion,
    const std::vector<LinkMotion<Scalar>>& links,
    const std::vector<Matrix<Scalar>>& poses) {
  const Vector<Scalar> qd = joint_rates(robot, motion.qd), qdd = joint_accelerations(robot, motion);
  Vector<Scalar> forces(6 + robot.dof());
  for (int j = 0; j < robot.joints.size; ++j) {
    const JointDrive& drive = robot.joints[j].drive;
    if (!has_inertia(drive)) continue;
    const Vector<Scalar> row = row_of_joint<Scalar>(robot, j);
    forces += (inertia_of<Scalar>(drive) * qdd(j)) * row;
    if (drive.rotor_carrier < 0) continue;
    const LinkMotion<Scalar>& carrier = links[static_cast<std::size_t>(drive.rotor_carrier)];
    const Vector<Scalar> spin = momentum_of_rotor<Scalar>(drive) * rotor_axis(drive, carrier.pose);
    forces += dot(spin, carrier.angular_acceleration()) * row;
    const Vector<Scalar> moment = qdd(j) * spin + qd(j) * cross(carrier.angular_velocity(), spin);
    const Matrix<Scalar> J = body_jacobian(robot, poses, drive.rotor_carrier, Vector<Scalar>(3));
    forces += transpose(J) * stacked(moment, Vector<Scalar>(3));
  }
  return forces;
}

// The part of the kinetic energy (J) that the lumped mass properties of the carriers do not include.
template <class Scalar>
Scalar energy_of_drives(const Robot& robot, const Vector<Scalar>& rates, const std::vector<LinkMotion<Scalar>>& links) {
  const Vector<Scalar> qd = joint_rates(robot, rates);
  Scalar energy(0);
  for (int j = 0; j < robot.joints.size; ++j) {
    const JointDrive& drive = robot.joints[j].drive;
    energy += inertia_of<Scalar>(drive) * qd(j) * qd(j) / 2;
    if (drive.rotor_carrier < 0) continue;
    const LinkMotion<Scalar>& carrier = links[static_cast<std::size_t>(drive.rotor_carrier)];
    energy +=
        momentum_of_rotor<Scalar>(drive) * qd(j) * dot(rotor_axis(drive, carrier.pose), carrier.angular_velocity());
  }
  return energy;
}

// Angular momentum (N m s) of the spin of all rotors, in base coordinates.
template <class Scalar>
Vector<Scalar> momentum_of_rotors(
    const Robot& robot,
    const Vector<Scalar>& rates,
    const std::vector<LinkMotion<Scalar>>& links) {
  const Vector<Scalar> qd = joint_rates(robot, rates);
  Vector<Scalar> total(3);
  for (int j = 0; j < robot.joints.size; ++j) {
    const JointDrive& drive = robot.joints[j].drive;
    if (drive.rotor_carrier < 0) continue;
    const Matrix<Scalar>& pose = links[static_cast<std::size_t>(drive.rotor_carrier)].pose;
    total += momentum_of_rotor<Scalar>(drive) * qd(j) * rotor_axis(drive, pose);
  }
  return total;
}

// Coulomb friction of unit size, smoothed over `velocity`.
template <class Scalar>
Scalar friction_direction(const Scalar& qd, double velocity) {
  if (velocity == 0) return Scalar(qd > Scalar(0) ? 1 : qd < Scalar(0) ? -1 : 0);
  return qd / std::sqrt(qd * qd + Scalar(velocity) * Scalar(velocity));
}

// The forces that the joints must overcome in tendons: the gradient of stiffness (length - rest)^2 / 2 by the positions
// of joints, and that of damping (rate of the length)^2 / 2 by their rates.
template <class Scalar>
Vector<Scalar> tendon_forces(const Robot& robot, const Motion<Scalar>& motion) {
  const Vector<Scalar> q = joint_positions(robot, motion.q), qd = joint_rates(robot, motion.qd);
  Vector<Scalar> forces(robot.joints.size);
  for (const reflection::Tendon& tendon : robot.tendons) {
    Scalar length(0), rate(0);
    for (int j = 0; j < robot.joints.size; ++j) {
      // A spherical joint has no position that a tendon could depend on.
      if (tendon.factors[j] == 0) continue;
      length += Scalar(tendon.factors[j]) * q(j);
      rate += Scalar(tendon.factors[j]) * qd(j);
    }
    const Scalar tension = Scalar(tendon.stiffness) * (length - Scalar(tendon.rest)) + Scalar(tendon.damping) * rate;
    for (int j = 0; j < robot.joints.size; ++j) forces(j) += Scalar(tendon.factors[j]) * tension;
  }
  return transpose(coupling_matrix<Scalar>(robot)) * forces;
}

// The forces that the joints must overcome in their drives: damping, friction, springs, without those of tendons.
template <class Scalar>
Vector<Scalar> forces_within_joints(const Robot& robot, const Motion<Scalar>& motion) {
  const Vector<Scalar> q = joint_positions(robot, motion.q), qd = joint_rates(robot, motion.qd);
  Vector<Scalar> forces(robot.joints.size);
  for (int j = 0; j < robot.joints.size; ++j) {
    const JointDrive& drive = robot.joints[j].drive;
    forces(j) = Scalar(drive.damping) * qd(j) +
                Scalar(drive.friction) * friction_direction(qd(j), drive.friction_velocity) +
                Scalar(drive.stiffness) * (q(j) - Scalar(drive.rest));
  }
  return transpose(coupling_matrix<Scalar>(robot)) * forces;
}

// All passive forces.
template <class Scalar>
Vector<Scalar> passive_forces(const Robot& robot, const Motion<Scalar>& motion) {
  return forces_within_joints(robot, motion) + tendon_forces(robot, motion);
}

// Those that inverse and forward dynamics include.
template <class Scalar>
Vector<Scalar> passive_forces_of_dynamics(const Robot& robot, const Motion<Scalar>& motion) {
  return robot.passive_forces ? passive_forces(robot, motion) : tendon_forces(robot, motion);
}

}  // namespace robcogen::reference
