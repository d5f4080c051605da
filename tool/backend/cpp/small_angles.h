// Kernels in lanes whose sines and cosines need no test for large angles.
#pragma once

#include "backend/common/lower.h"
#include "symbolic/program.h"

namespace robcogen::backend::cpp {

// Whether the kernel has sines and cosines in lanes, and robcogen::are_small for the joint positions implies that all
// of their angles are small: the angles are sums of at most three positions, some negated.
bool has_small_angles(const symbolic::Program& program, const Kernel& kernel);

// Marks the sines and cosines in a kernel that is called for small angles only.
Kernel of_small_angles(Kernel kernel);

}  // namespace robcogen::backend::cpp
