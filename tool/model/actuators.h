// Linear actuators between frames.
#pragma once

#include "model/description.h"
#include "model/kinematic_tree.h"

namespace robcogen::model {

// Adds the described actuators to the tree, whose loops are already resolved. Reports names that are taken or unknown,
// and actuators that move nothing.
void resolve_actuators(const Description& description, KinematicTree& tree, Diagnostics& diagnostics);

}  // namespace robcogen::model
