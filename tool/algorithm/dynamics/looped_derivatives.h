// Derivatives for robots with loops, by the chain rule over expressions: the matrix G of the rates of all joints by
// those of the coordinates (couplings.h) depends on q, and forces by coordinate change with G too.
#pragma once

#include <vector>

#include "algorithm/dynamics/force_derivatives.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {

// The wrench of a floating base, then the forces of coordinates, from those of all joints.
std::vector<Expression> generalized_forces(Trace& trace, const Force& base_wrench, const std::vector<Expression>& tau);

// The derivatives of these expressions by the positions of coordinates (for spherical joints by turns), a column for
// each. Joints that follow others in q move as their loops require. Expressions in `held` have the given rates,
// whatever they depend on.
Columns derivatives_by_positions(
    Trace& trace,
    const std::vector<Expression>& of,
    const std::vector<Expression>& q,
    const std::vector<symbolic::Rate>& held = {});

// The rates of these expressions while the joints move with the velocities in.qd, which stay the same.
std::vector<Expression> rates_along_motion(Trace& trace, const std::vector<Expression>& of, const StateInputs& in);

// The same by the velocities of coordinates, and by one velocity.
Columns derivatives_by_velocities(
    Trace& trace,
    const std::vector<Expression>& of,
    const std::vector<Expression>& qd,
    const std::vector<symbolic::Rate>& held);
std::vector<Expression> derivative_by_velocity(
    Trace& trace,
    const std::vector<Expression>& of,
    const Expression& velocity,
    std::vector<symbolic::Rate> held);

// Results that are to be held constant, as expressions that do not fold with what they are computed from. (A wheel with
// damping accelerates with (tau - b qd) / I, so that I times that plus b qd would fold to tau.) This concerns multiples
// of a value by a constant: others stay the same expressions.
std::vector<Expression> held_apart(Trace& trace, const std::vector<Expression>& results);

// Holds the accelerations of coordinates and base constant, even if they are results.
std::vector<symbolic::Rate> held_accelerations(const model::KinematicTree& tree, const StateInputs& in);

// The same as force_derivatives. in.qdd (by joint) and in.base_acceleration may be inputs or results; forces.tau must
// have all joint forces, including passive ones.
ForceDerivatives looped_force_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const Vector3& gravity,
    const Forces& forces);

}  // namespace robcogen::algorithm
