// Random couplings for random robots.
#pragma once

#include <cstdint>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

struct CoupledRobot {
  model::KinematicTree robot;
  std::vector<double> parameters;  // values, where factors and offsets depend on parameters
};

// The robot with about a third of its joints coupled, the same ones for the same seed: followers with factors of one,
// minus one and others, differentials, joints that stand still. At least one joint stays independent.
CoupledRobot coupled(const model::KinematicTree& free, std::uint64_t seed, bool parametric = false);

}  // namespace robcogen::numeric
