// The data of a robot in a library: links, joints, frames, parameters.
#pragma once

#include "backend/library.h"
#include "model/kinematic_tree.h"

namespace robcogen::driver {

// Adds links, joints, frames and parameters. Their constants are evaluated with the defaults of the parameters; numbers
// that depend on a parameter without default are NaN.
void add_model(const model::KinematicTree& tree, backend::Library& library);

}  // namespace robcogen::driver
