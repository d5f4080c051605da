// Partial derivatives of the forces of inverse dynamics as expressions, for algorithms that use them.
#pragma once

#include <vector>

#include "algorithm/dynamics/newton_euler.h"

namespace robcogen::algorithm {

// Of (base wrench, tau), or of tau on a fixed base. The base's columns only where it floats.
struct ForceDerivatives {
  Columns q, qd, qdd;         // by coordinate; qdd: of the joint-space inertia matrix
  Columns base_rotation;      // 3: by a turn of the base about its own axes, under gravity that stays
  Columns base_velocity;      // 6
  Columns base_acceleration;  // 6: of the joint-space inertia matrix
};

// Rows and columns by coordinate, about the motion that the forces belong to. External wrenches are constant in the
// coordinates of their links. Of robots with loops by looped_derivatives.h, which says what that takes.
ForceDerivatives force_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const Vector3& gravity,
    const Forces& forces);

// The columns of a turn of the base and of its linear velocity: what these change, they change like a linear
// acceleration of the base.
void fill_free_columns(const Vector3& gravity, const Vector3& base_w, ForceDerivatives& d);

// Of (base acceleration, joints) of a robot whose base nothing holds, by a turn and by the linear velocity of the base:
// in the world the robot moves as before.
void fill_free_fall(Trace& trace, const Vector3& base_w, const Vector3& gravity, ForceDerivatives& d);

}  // namespace robcogen::algorithm
