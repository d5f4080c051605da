// The regressor of drives: their contribution to inverse dynamics, as a linear function of their parameters.
#pragma once

#include <string>
#include <vector>

#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// For each joint, coupled ones last: inertia that the joint alone moves (armature, and that of a rotor times its ratio
// squared; kg m^2, kg), damping, Coulomb friction, stiffness of a spring, and a constant force (minus stiffness times
// rest, if the document has a spring). The same for each component of a spherical joint; its column of stiffness is
// zero. Then, for each rotor on a link that moves, its inertia times its ratio.
std::vector<std::string> drive_parameter_names(const model::KinematicTree& tree);

// -> pi: the numbers of the document, whether inverse dynamics uses passive forces or not.
symbolic::Program drive_parameters(const model::KinematicTree& tree, const std::string& name);

// q, qd, qdd [, base_velocity, base_acceleration] -> Y. The rows are those of the regressor. The sign of a velocity,
// which friction multiplies, is as smooth as in the document: it is sign(qd) if the document has no velocity below
// which friction falls.
symbolic::Program drive_regressor(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
