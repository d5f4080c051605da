// The dynamics algorithms, each written once over symbolic scalars: model in, program out.
//
// Conventions of all of them: SI units; joint arrays in the order of the document's joints; 6D vectors angular first;
// base twist, base acceleration (spatial, gravity not included), gravity and base wrench in base coordinates about the
// base origin; an external wrench acts on its link, in link coordinates about the link's origin.
#pragma once

#include <string>

#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// How gravity and external wrenches enter a program.
enum class Loads {
  standard_gravity,      // (0, 0, -9.81) m/s^2 in base coordinates, folded
  gravity,               // `gravity` is an input
  gravity_and_external,  // and so is `external`
};

inline constexpr double kStandardGravity = 9.81;  // m/s^2, along -z of the base frame

// Recursive Newton-Euler (Featherstone 2008, table 5.1). Fixed base: q, qd, qdd -> tau. Floating base, fully actuated:
// q, qd, qdd, base_velocity, base_acceleration -> tau, base_wrench.
symbolic::Program newton_euler(const model::KinematicTree& tree, const std::string& name, Loads loads);

// Floating base that nothing holds (Featherstone 2008, table 9.6): q, qd, qdd, base_velocity -> tau, base_acceleration.
symbolic::Program unactuated_base_inverse_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads);

// Forces at zero acceleration: q, qd [, base_velocity] -> tau [, base_wrench].
symbolic::Program bias_forces(const model::KinematicTree& tree, const std::string& name, Loads loads);

// The part of the bias forces that velocities cause.
symbolic::Program coriolis_forces(const model::KinematicTree& tree, const std::string& name);

// The part that gravity causes, from the first moments of composite bodies: q -> tau [, base_wrench].
symbolic::Program gravity_forces(const model::KinematicTree& tree, const std::string& name, Loads loads);

// Articulated-body algorithm (Featherstone 2008, table 7.1), split into bias forces and a homogeneous part: q, qd, tau
// [, base_velocity] -> qdd [, base_acceleration].
symbolic::Program forward_dynamics(const model::KinematicTree& tree, const std::string& name, Loads loads);

// Composite-rigid-body algorithm (Featherstone 2008, table 6.2): q -> H, n x n, or (6 + n) x (6 + n) base first. The
// zeros that branches induce are literal.
symbolic::Program joint_space_inertia(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
