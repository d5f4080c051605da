// A header that the motion planner VAMP includes like those of its own robots: a structure over the checks of the
// library in C++ (collision_check.h). What does not depend on the robot is in <robcogen/vamp.h>.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"
#include "support/diagnostics.h"

namespace robcogen::backend::vamp {

// The groups of functions that the header calls: also the transform of the end effector to the base.
const std::vector<std::string>& groups();

// Reports a robot that VAMP cannot plan for.
void check(const model::KinematicTree& tree, Diagnostics& diagnostics);

// `vamp/robots/<name>.hh`, with the name in small letters, as VAMP calls its headers.
std::string output(const std::string& name);

// `end_effector`: the name of its frame in the library.
OutputFile print(const Library& library, const std::string& end_effector);

}  // namespace robcogen::backend::vamp
