// The joint-space inertia matrix as expressions, for algorithms that go on from it.
#pragma once

#include <vector>

#include "algorithm/setup.h"

namespace robcogen::algorithm {

// H by composite rigid bodies (Featherstone 2008, table 6.2), column by column; a floating base's 6 rows and columns
// first. Zeros that branches induce are the constant zero.
std::vector<Expression> joint_space_inertia(const Setup& setup);

// The rows of H, ancestors first: eliminated from the last to the first they fill nothing in.
std::vector<int> elimination_order(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
