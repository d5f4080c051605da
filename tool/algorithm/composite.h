// Composite rigid bodies: a link and all beyond it, frozen at the present joint positions.
#pragma once

#include <vector>

#include "algorithm/setup.h"

namespace robcogen::algorithm {

// By link, about the link's origin in link axes. The base's only when it floats.
std::vector<MassProperties> composite_bodies(const Setup& setup);

// All that moves, frozen: every link but a fixed base; about the base origin in base axes.
MassProperties moving_body(const Setup& setup, const std::vector<MassProperties>& composite);

// The wrench that accelerates the composite body by one unit of the joint that supports it (zero velocity), and its
// momentum at unit rate.
Spatial unit_wrench(const MassProperties& composite, bool revolute);

// -I^-1 wrench: how a free rigid body accelerates when `missing` is not supplied.
Spatial rigid_body_acceleration(Trace& trace, const MassProperties& body, const Spatial& missing);

// Adds to tau[j] what a common acceleration of the base asks of joint j.
void add_composite_forces(
    const Setup& setup,
    const std::vector<MassProperties>& composite,
    const Spatial& base_acceleration,
    std::vector<Expression>& tau);

}  // namespace robcogen::algorithm
