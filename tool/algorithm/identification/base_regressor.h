// The regressor of base inertial parameters: the fewest combinations of inertial parameters that forces depend on
// (Gautier and Khalil 1990; Khalil and Dombre 2002, sec. 9.4). With a fixed base these are fewer under standard gravity
// than where gravity is an input, which may have any direction.
#pragma once

#include <string>
#include <vector>

#include "algorithm/identification/regressor.h"

namespace robcogen::algorithm {

// The combinations as text, in order: `arm_hx - 0.3 hand_m`. `(...)` stands for coefficients that depend on parameters
// of the document.
std::vector<std::string> base_parameter_names(const model::KinematicTree& tree, Loads loads);

// inertial_parameters (of the links that move, about their origins) -> beta.
symbolic::Program base_parameters(const model::KinematicTree& tree, const std::string& name, Loads loads);

// q, qd, qdd [, base_velocity, base_acceleration] [, gravity] -> Y, columns of the regressor, so that Y times the base
// parameters is the regressor times the inertial parameters.
symbolic::Program base_regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative = {});

}  // namespace robcogen::algorithm
