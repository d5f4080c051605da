// The groups of functions: what a library can have, and what a robot must have for them.
#pragma once

#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// In canonical order (groups.inc).
const std::vector<std::string>& groups();

// The default groups of a robot: those that most programs need and that compile quickly.
const std::vector<std::string>& default_groups();

// Whether the robot's mass properties allow the functions of this group: functions that divide by the joint-space
// inertia matrix need a regular matrix, those of the centre of mass need mass, and all of the dynamics need inertia.
bool is_available(const model::KinematicTree& tree, const std::string& group);

// Why a group is not available; empty if it is. With `other_than_masses` it is also empty if the mass properties do not
// allow the group, which diagnostics of the model say.
enum class Reasons { all, other_than_masses };
std::string reason_of_absence(const model::KinematicTree& tree, const std::string& group, Reasons reasons);

}  // namespace robcogen::algorithm
