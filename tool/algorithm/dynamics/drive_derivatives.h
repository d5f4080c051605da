// What the drives of joints (drives.h) add to the derivatives of inverse dynamics.
#pragma once

#include "algorithm/dynamics/force_derivatives.h"

namespace robcogen::algorithm {

// Adds springs, friction and armature, which nothing but the joint itself moves, to derivatives whose rows and columns
// are joints. Those of a robot with coupled joints become derivatives by coordinate.
void add_drives(Trace& trace, const StateInputs& in, ForceDerivatives& d);

}  // namespace robcogen::algorithm
