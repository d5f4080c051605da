// Reads which pairs of links need no collision check.
#pragma once

#include <memory>

#include "model/kinematic_tree.h"
#include "support/diagnostics.h"

namespace robcogen::import {

// Reads the elements `disable_collisions` of an SRDF into the geometry of the tree. Other elements have no effect on
// collision checks, except those that change them by default, which cause a warning. Warns about links that the robot
// does not have. Returns false if an error was reported.
bool read_srdf(const std::shared_ptr<const Source>& source, model::KinematicTree& tree, Diagnostics& diagnostics);

}  // namespace robcogen::import
