// Kernels in lanes whose sines and cosines need no test for large angles.
#pragma once

#include "backend/common/lower.h"
#include "symbolic/program.h"

namespace robcogen::backend::cpp {

// Whether robcogen::are_small of the joint positions implies small angles for all sines and cosines in lanes of the
// kernel, and there are some: their angles are sums of at most three positions, some negated.
bool has_small_angles(const symbolic::Program& program, const Kernel& kernel);

// Marks them in a kernel that is called for small angles only.
Kernel of_small_angles(Kernel kernel);

}  // namespace robcogen::backend::cpp
