// Finds functions by the names that users read and write: `inverse_dynamics`, `jacobians.fr_base_J_fr_foot`.
#pragma once

#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"

namespace robcogen::algorithm {

// `jacobians.fr_base_J_fr_foot`: the scope with dots, and the name.
std::string dotted(const std::string& scope, const std::string& name);

// The overloads of the robot's function with this name, fewest inputs first; empty if it has none. They may be between
// frames that its list of desired transforms does not have. Functions that the list fuses are not found.
std::vector<Declared> find_function(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name);
// The same with the tasks of inverse kinematics of a list.
std::vector<Declared> find_function(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& name);

}  // namespace robcogen::algorithm
