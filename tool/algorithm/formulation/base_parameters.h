// Base inertial parameters: mass properties that a joint does not feel move to the parent link.
//
// Mass on the axis of a revolute joint has the same effect on the parent, and so has all of the pseudo-inertia behind a
// prismatic joint: seven and four numbers remain for a link, none where they go into a fixed base (base inertial
// parameters: Gautier, Khalil 1990; Mayeda, Yoshida, Osuka 1990; with pseudo-inertias, in which S_zz is the null
// direction of a revolute joint). A helical joint, which turns and slides, leaves S_zz alone to the parent. Inverse
// dynamics, inertia matrix, kinetic energy and forward dynamics stay what they were. The bodies are not physical any
// more: masses can be zero or negative, and functions of the masses must not use them.
#pragma once

#include <vector>

#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// By link; in constants, exact up to rounding; in parameters, sums of products that depend on parameters only.
std::vector<MassProperties> regrouped(Trace& trace, const std::vector<Pose>& poses, std::vector<MassProperties> masses);

}  // namespace robcogen::algorithm
