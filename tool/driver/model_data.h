// The data of a robot in a library: links, joints, frames, parameters.
#pragma once

#include "backend/library.h"
#include "model/kinematic_tree.h"

namespace robcogen::driver {

// Links, joints, frames and parameters, with their constants as far as the defaults of the parameters determine them:
// numbers that depend on a parameter without default are NaN.
void add_model(const model::KinematicTree& tree, backend::Library& library);

}  // namespace robcogen::driver
