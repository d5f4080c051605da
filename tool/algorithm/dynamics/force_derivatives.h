// Partial derivatives of the forces of inverse dynamics as expressions, for algorithms that use them.
#pragma once

#include <vector>

#include "algorithm/dynamics/newton_euler.h"

namespace robcogen::algorithm {

// The derivatives of (base wrench, tau), or of tau on a fixed base. Columns of the base only if it floats.
struct ForceDerivatives {
  Columns q, qd, qdd;         // by coordinate; qdd: columns of the joint-space inertia matrix
  Columns base_rotation;      // 3: by a turn of the base about its own axes, with gravity fixed in the world
  Columns base_velocity;      // 6
  Columns base_acceleration;  // 6: columns of the joint-space inertia matrix
};

// Rows and columns are by coordinate, at the motion that the forces belong to. External wrenches are constant in the
// coordinates of their links. For robots with loops see looped_derivatives.h, which has further requirements.
// `passive`: whether they have the passive forces of the drives.
enum class PassiveForces { included, left_out };
ForceDerivatives force_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const Vector3& gravity,
    const Forces& forces,
    PassiveForces passive = PassiveForces::included);

// Fills the columns of a turn of the base and of its linear velocity, which change forces like a linear acceleration of
// the base.
void fill_free_columns(const Vector3& gravity, const Vector3& base_w, ForceDerivatives& d);

// The same columns for (base acceleration, joints) of a robot with an unactuated base: its motion in the world does not
// change.
void fill_free_fall(Trace& trace, const Vector3& base_w, const Vector3& gravity, ForceDerivatives& d);

}  // namespace robcogen::algorithm
