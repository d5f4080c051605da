// The ends of loops and actuators, which connect two frames across joints.
#pragma once

#include <array>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// The joints that move a link, in order from the base.
std::vector<int> joints_from_base(const KinematicTree& tree, int link);

// Returns the two ends, each with the joints that move it relative to the other. Neither end has joints if both frames
// are on one link.
std::array<LoopEnd, 2> ends_between(const KinematicTree& tree, const Frame& first, const Frame& second);

}  // namespace robcogen::model
