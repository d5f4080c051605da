// Slides by parameters, before or behind the joints that turn about their direction: the motion of the chain is the
// same. Axes can meet only where no slide is between them, so it matters for features where the slides are.
#pragma once

#include <vector>

#include "algorithm/kinematics/inverse/serial_chain.h"

namespace robcogen::algorithm::inversion {

// The arrangements in which most axes meet or are parallel; the chain itself if no slide can be moved.
std::vector<SerialChain> arrangements(const SerialChain& chain);

}  // namespace robcogen::algorithm::inversion
