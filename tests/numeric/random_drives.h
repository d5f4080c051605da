// Random drives on the joints of random robots.
#pragma once

#include <cstdint>

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// The robot with a random drive on most of its joints; the same for the same seed.
model::KinematicTree with_random_drives(model::KinematicTree robot, std::uint64_t seed);

}  // namespace robcogen::numeric
