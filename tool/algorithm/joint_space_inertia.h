// The joint-space inertia matrix as expressions, for algorithms that go on from it.
#pragma once

#include <vector>

#include "algorithm/setup.h"

namespace robcogen::algorithm {

// H by composite rigid bodies (Featherstone 2008, table 6.2), column by column; a floating base's 6 rows and columns
// first. Zeros that branches induce are the constant zero.
std::vector<Expression> joint_space_inertia(const Setup& setup);

}  // namespace robcogen::algorithm
