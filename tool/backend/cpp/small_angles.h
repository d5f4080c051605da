// Which kernels in lanes can leave out of each sine and cosine the question whether the angle is large.
#pragma once

#include "backend/common/lower.h"
#include "symbolic/program.h"

namespace robcogen::backend::cpp {

// Whether robcogen::are_small of the joint positions answers it for all sines and cosines in lanes of the kernel that
// the program was lowered to, and there are some: their angles are sums of at most three positions, some negated.
bool has_small_angles(const symbolic::Program& program, const Kernel& kernel);

// Marks them in a kernel that is called for small angles only.
Kernel of_small_angles(Kernel kernel);

}  // namespace robcogen::backend::cpp
