// How large the terms are that a result is the sum of: the yardstick for its rounding errors, where terms may cancel.
#pragma once

#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

// Sizes of the moment and the force that a link needs, as if nothing cancelled.
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
  double inertia = 0;  // about the link origin: the central one is a difference
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

// For each generalised force (base wrench, tau): the contribution of the links beyond.
inline Vector<double> force_terms(const Robot& robot, const Motion<double>& motion, const Loads<double>& loads) {
  // A centre of mass on a joint's axis has no lever but a position, and that is rounded.
  constexpr double kPosition = 1e-3;
  const std::vector<LinkMotion<double>> links = link_motions(robot, motion);
  Vector<double> sums(6 + robot.joints.size);
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
      sums(6 + j) += robot.joints[j].revolute ? terms.moment + lever * terms.force : terms.force;
    }
  }
  return sums;
}

}  // namespace robcogen::reference
