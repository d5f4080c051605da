// Functions that users fuse of others, in a list of desired transforms or in an option.
#pragma once

#include <string>
#include <vector>

#include "language/desired/document.h"
#include "model/kinematic_tree.h"
#include "support/diagnostics.h"
#include "symbolic/function.h"

namespace robcogen::driver {

// The definitions in the texts of an option: `control = bias_forces + jacobians.fr_base_J_fr_foot`. A text may have
// several.
std::vector<model::FusedFunction> functions_of_option(
    const std::string& option,
    const std::vector<std::string>& texts,
    Diagnostics& diagnostics);

// import::desired_transforms, with functions that the robot has.
model::DesiredTransforms checked_desired_transforms(
    const language::desired::Document& document,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// Reports what keeps the robot from having these functions: an unknown part, a name that is taken, and so on.
void check_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    Diagnostics& diagnostics);

// Throws a Failure if the program of a fused function is too long to compile.
void require_compilable(const symbolic::Function& function);

}  // namespace robcogen::driver
