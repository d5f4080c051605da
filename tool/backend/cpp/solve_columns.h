// The body of a kernel whose results are solutions for many right-hand sides (Function::solved).
#pragma once

#include <string>

#include "backend/cpp/compiled_kernels.h"

namespace robcogen::backend::cpp {

// Calls the stage that computes right-hand sides and a factor, and solves for the columns of each block: one in each
// lane of a register, and of limbs one of each limb, where these fill it.
std::string solve_columns(const Callable& callable);

}  // namespace robcogen::backend::cpp
