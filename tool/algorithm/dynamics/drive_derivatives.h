// The contribution of drives (drives.h) to the derivatives of inverse dynamics.
#pragma once

#include "algorithm/dynamics/force_derivatives.h"

namespace robcogen::algorithm {

// Adds springs, friction and armature, which depend on the motion of their own joint only, and tendons, which depend on
// the motion of several, to derivatives whose rows and columns are joints. For a robot with coupled joints, the result
// is reduced to derivatives by coordinate.
void add_drives(Trace& trace, const StateInputs& in, ForceDerivatives& d, PassiveForces passive);

}  // namespace robcogen::algorithm
