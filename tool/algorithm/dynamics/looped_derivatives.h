// Derivatives of robots with loops, by the chain rule over expressions: joints that follow turn with the others in
// proportions that change, so that forces of joints change with G too.
#pragma once

#include <vector>

#include "algorithm/dynamics/force_derivatives.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {

// The wrench of a floating base, then the forces of coordinates, from those of all joints.
std::vector<Expression> generalized_forces(Trace& trace, const Force& base_wrench, const std::vector<Expression>& tau);

// Of these expressions, by the positions of coordinates, by turns for spherical joints: a column each. Joints that
// follow in q move as their loops have it. `held` does not change, whatever it depends on.
Columns derivatives_by_positions(
    Trace& trace,
    const std::vector<Expression>& of,
    const std::vector<Expression>& q,
    const std::vector<symbolic::Rate>& held = {});

// As force_derivatives: in.qdd, by joint, and in.base_acceleration may be inputs or results; forces.tau has all forces
// of joints, passive ones too.
ForceDerivatives looped_force_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const Vector3& gravity,
    const Forces& forces);

}  // namespace robcogen::algorithm
