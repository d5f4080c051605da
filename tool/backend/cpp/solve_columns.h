// The body of a kernel whose results are solutions for many right-hand sides (Function::solved).
#pragma once

#include <string>

#include "backend/cpp/compiled_kernels.h"

namespace robcogen::backend::cpp {

// The code that calls the function of right-hand sides and a factor, and solves for the columns of each block:
// one column per lane of a register. Columns of limbs are solved with one limb per lane, if the limbs fill the
// register.
std::string solve_columns(const Callable& callable);

}  // namespace robcogen::backend::cpp
