// Forward dynamics by articulated bodies, as expressions.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

struct ForwardMotion {
  std::vector<Expression> qdd;
  Motion base_acceleration;
};

// Featherstone 2008, table 7.1, split into bias forces and a homogeneous part.
ForwardMotion by_articulated_bodies(const TracedRobot& robot, const StateInputs& in, const LoadInputs& load);

}  // namespace robcogen::algorithm
