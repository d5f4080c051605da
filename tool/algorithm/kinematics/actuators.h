// Linear actuators between two frames: their lengths, and how these change with the coordinates. By virtual work the
// lever arms map the forces of actuators to the forces of joints.
#pragma once

#include <string>

#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// q -> lengths, m: one per actuator.
symbolic::Program actuator_lengths(const model::KinematicTree& tree, const std::string& name);

// q, qd -> rates of the lengths, m/s.
symbolic::Program actuator_velocities(const model::KinematicTree& tree, const std::string& name);

// q -> J, a row per actuator, a column per coordinate: lever arms (m), or pure numbers for a joint that slides.
symbolic::Program actuator_jacobian(const model::KinematicTree& tree, const std::string& name);

// q, forces -> J' forces.
symbolic::Program actuator_torques(const model::KinematicTree& tree, const std::string& name);

// Whether each actuator moves one coordinate that no other actuator moves: then the forces of actuators follow from
// tau.
bool drives_separate_coordinates(const model::KinematicTree& tree);

// q, tau -> forces such that J' forces is tau at the coordinates that actuators move. Only if these are separate.
symbolic::Program actuator_forces(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
