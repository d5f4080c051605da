// Mass properties that a joint does not feel, moved to where they cost nothing.
//
// Mass on the axis of a revolute joint does as well on the parent, and so does all of a slider's pseudo-inertia: seven
// and four numbers remain to a link, none where they go into a fixed base (base inertial parameters: Gautier, Khalil
// 1990; Mayeda, Yoshida, Osuka 1990; with pseudo-inertias, in which S_zz is the null direction of a revolute joint).
// Inverse dynamics, inertia matrix, kinetic energy and forward dynamics stay what they were. The bodies are no physical
// ones any more: masses can be zero or negative, and what is asked about masses must not see them.
#pragma once

#include <vector>

#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// By link; in constants, exact up to rounding; in parameters, sums of products that depend on parameters only.
std::vector<MassProperties> regrouped(Trace& trace, const std::vector<Pose>& poses, std::vector<MassProperties> masses);

}  // namespace robcogen::algorithm
