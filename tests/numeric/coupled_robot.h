// Random couplings for random robots.
#pragma once

#include <cstdint>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

struct CoupledRobot {
  model::KinematicTree robot;
  std::vector<double> parameters;  // values of the parameters that factors and offsets depend on
};

// Couples about a third of the robot's joints: followers with a factor of one, minus one or another number,
// differentials, and joints that stand still. The choice depends only on the seed, and at least one joint stays
// independent.
CoupledRobot coupled(const model::KinematicTree& free, std::uint64_t seed, bool parametric = false);

}  // namespace robcogen::numeric
