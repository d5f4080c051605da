// Check of the total mass of a robot with parameters.
#pragma once

#include "robcogen/reference/check_dynamics.h"

namespace robcogen::reference {

// The mass of all moving links, or zero if all of them are massless.
template <class Subject>
void check_total_mass(const Subject& subject, const Robot& robot, Checks& checks, int sample) {
  Real mass = 0;
  for (const reflection::Link& link : robot.links) {
    if (robot.floating_base || link.parent_joint >= 0) mass += link.mass;
  }
  const Real difference = std::abs(subject.total_mass() - mass);
  checks.record("total_mass", kInertia, difference == 0 ? 0 : difference / mass, sample);
}

}  // namespace robcogen::reference
