// What has no spherical joints yet.
#pragma once

#include <string>

#include "model/kinematic_tree.h"

namespace robcogen::command {

// A Failure `<place>: error: <reason>: '<joint>' of robot '<name>' is spherical`, with the hint, at the first spherical
// joint of the robot; nothing where it has none.
void refuse_spherical_joints(const model::KinematicTree& tree, const std::string& reason, const std::string& hint = "");

}  // namespace robcogen::command
