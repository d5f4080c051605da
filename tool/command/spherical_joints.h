// Refuses robots with spherical joints, where these are not supported.
#pragma once

#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::command {

// Throws a Failure `<place>: error: <reason>: '<joint>' of robot '<name>' is spherical`, with the hint, at the first
// spherical joint of the robot. Does nothing if the robot has none.
void refuse_spherical_joints(const model::KinematicTree& tree, const std::string& reason, const std::string& hint = "");

}  // namespace robcogen::command
