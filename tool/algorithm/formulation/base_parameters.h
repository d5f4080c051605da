// Base inertial parameters: mass properties that a joint does not feel move to the parent link.
//
// Mass on the axis of a revolute joint has the same effect if it belongs to the parent, and so does the whole
// pseudo-inertia of the child of a prismatic joint. Seven and four numbers remain for such a link; the others vanish if
// the parent is a fixed base (base inertial parameters: Gautier, Khalil 1990; Mayeda, Yoshida, Osuka 1990; with
// pseudo-inertias, in which S_zz is the null direction of a revolute joint). A helical joint, which turns and slides,
// passes only S_zz to the parent. Inverse dynamics, inertia matrix, kinetic energy and forward dynamics do not change.
// The resulting bodies are not physical: masses can be zero or negative, and functions of the masses themselves must
// not use them.
#pragma once

#include <vector>

#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {

// The mass properties that remain, by link. Constants are exact up to rounding; with parameters they are sums of
// products that depend on parameters only.
std::vector<MassProperties> with_base_parameters(
    Trace& trace,
    const std::vector<Pose>& poses,
    std::vector<MassProperties> masses);

}  // namespace robcogen::algorithm
