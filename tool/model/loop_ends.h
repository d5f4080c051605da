// The ends of what connects two frames across joints: loops and actuators.
#pragma once

#include <array>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// The joints that move a link, in order from the base.
std::vector<int> joints_from_base(const KinematicTree& tree, int link);

// With the joints that move one with respect to the other; both have none where the frames are on one link.
std::array<LoopEnd, 2> ends_between(const KinematicTree& tree, const Frame& first, const Frame& second);

}  // namespace robcogen::model
