// Which algorithm computes a robot's forward dynamics, and in which link frames.
#pragma once

#include <string>

#include "algorithm/dynamics/dynamics.h"

namespace robcogen::algorithm {

// The method with the smaller predicted time (symbolic::predicted_time), each in the link frames that suit it.
ForwardDynamicsChoice forward_dynamics_choice(const model::KinematicTree& tree, const Formulation& formulation = {});

// Forward dynamics with the choice for this formulation.
symbolic::Program forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation = {});

}  // namespace robcogen::algorithm
