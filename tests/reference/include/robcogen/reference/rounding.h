// The sizes of the terms that a result sums: the scale of its rounding errors, because terms may cancel.
#pragma once

#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

// Sizes of the moment and the force on a link, as if nothing cancelled.
struct WrenchTerms {
  double moment = 0;  // N m, about the centre of mass
  double force = 0;   // N
};

inline WrenchTerms wrench_terms(
    const Robot& robot,
    int link,
    const LinkMotion<double>& motion,
    const Loads<double>& loads) {
  const reflection::Link& body = robot.links[link];
  const Vector<double> com = center_of_mass<double>(body);
  double inertia = 0;  // about the link origin, because the central one is a difference
  for (const double moment : body.inertia) inertia = std::max(inertia, std::abs(moment));
  const double speed = largest(motion.angular_velocity());
  const double turning = largest(motion.angular_acceleration()) + speed * speed;
  const double acceleration = largest(motion.acceleration({0, 0, 0})) + turning * largest(com) + largest(loads.gravity);
  WrenchTerms terms{inertia * turning, std::abs(body.mass) * acceleration};
  if (!loads.external.empty()) {
    const Vector<double>& external = loads.external[static_cast<std::size_t>(link)];
    terms.moment += largest(external.head(3)) + largest(com) * largest(external.tail(3));
    terms.force += largest(external.tail(3));
  }
  return terms;
}

// Adds the terms of the drives and of tendons, to the base and to joints.
inline void add_drive_terms(
    const Robot& robot,
    const Motion<double>& motion,
    const std::vector<LinkMotion<double>>& links,
    Vector<double>& sums,
    Vector<double>& by_joint) {
  const Vector<double> q = joint_positions(robot, motion.q), qd = joint_rates(robot, motion.qd);
  const Vector<double> qdd = joint_accelerations(robot, motion);
  for (int j = 0; j < robot.joints.size; ++j) {
    const JointDrive& drive = robot.joints[j].drive;
    by_joint(j) += std::abs(inertia_of<double>(drive) * qdd(j)) + std::abs(drive.damping * qd(j)) +
                   std::abs(drive.friction) + std::abs(drive.stiffness) * (std::abs(q(j)) + std::abs(drive.rest));
    if (drive.rotor_carrier < 0) continue;
    const LinkMotion<double>& carrier = links[static_cast<std::size_t>(drive.rotor_carrier)];
    const double momentum = std::abs(momentum_of_rotor<double>(drive));
    by_joint(j) += momentum * largest(carrier.angular_acceleration());
    const double speed = largest(carrier.angular_velocity());
    const double moment = momentum * (std::abs(qdd(j)) + std::abs(qd(j)) * speed);
    for (int k = 0; k < 3; ++k) sums(k) += moment;
    for (const int i : supporting_joints(robot, drive.rotor_carrier))
      if (turns(robot.joints[i].type)) by_joint(i) += moment;
  }
  for (const reflection::Tendon& tendon : robot.tendons) {
    double tension = std::abs(tendon.stiffness * tendon.rest);
    for (int j = 0; j < robot.joints.size; ++j)
      if (tendon.factors[j] != 0)
        tension += std::abs(tendon.factors[j]) * (std::abs(tendon.stiffness * q(j)) + std::abs(tendon.damping * qd(j)));
    for (int j = 0; j < robot.joints.size; ++j) by_joint(j) += std::abs(tendon.factors[j]) * tension;
  }
}

// For each generalised force (base wrench, tau), the sizes of the terms of the links that it supports, and of drives.
inline Vector<double> force_terms(const Robot& robot, const Motion<double>& motion, const Loads<double>& loads) {
  // A centre of mass on a joint's axis has no lever arm, but its position is rounded.
  constexpr double kPosition = 1e-3;
  const std::vector<LinkMotion<double>> links = link_motions(robot, motion);
  Vector<double> sums(6 + robot.dof()), by_joint(robot.joints.size);
  for (int i = 0; i < robot.links.size; ++i) {
    const LinkMotion<double>& link = links[static_cast<std::size_t>(i)];
    const WrenchTerms terms = wrench_terms(robot, i, link, loads);
    const Vector<double> com = link.position(center_of_mass<double>(robot.links[i]));
    for (int k = 0; k < 3; ++k) {
      sums(k) += terms.moment + largest(com) * terms.force;
      sums(3 + k) += terms.force;
    }
    for (const int j : supporting_joints(robot, i)) {
      const Vector<double> origin = origin_of(links[static_cast<std::size_t>(robot.joints[j].child)].pose);
      const double lever = largest(com - origin) + kPosition * (largest(com) + largest(origin));
      const reflection::Joint& joint = robot.joints[j];
      if (turns(joint.type)) by_joint(j) += terms.moment + lever * terms.force;
      by_joint(j) += std::abs(slide_per_unit<double>(joint)) * terms.force;
    }
  }
  add_drive_terms(robot, motion, links, sums, by_joint);
  sums.set_block(6, 0, transpose(magnitude(coupling_matrix<double>(robot))) * by_joint);
  return sums;
}

}  // namespace robcogen::reference
