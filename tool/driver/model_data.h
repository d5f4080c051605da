// What a library says about the robot beside its functions.
#pragma once

#include "backend/library.h"
#include "model/kinematic_tree.h"

namespace robcogen::driver {

// Links, joints, frames and parameters, with their constants as far as the parameters' defaults determine them: what
// depends on a parameter without one is NaN.
void add_model(const model::KinematicTree& tree, backend::Library& library);

}  // namespace robcogen::driver
