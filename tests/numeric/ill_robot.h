// Robots whose numbers are ill on purpose: where a generator that is careless with digits loses them.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// Random trees of 1 to 12 joints, half of them with a floating base: axes that are parallel or at right angles but for
// 10^-1 … 10^-17 rad or for the digits that documents write of PI, centres of mass and products of inertia of 1e-18 and
// 1e-12, prismatic joints behind revolute ones, and in some robots offsets and masses over 12 decades. The same robot
// for the same seed, everywhere.
model::KinematicTree ill_robot(std::uint64_t seed);

// The robot with rotors on most of its joints, carried by any links with mass: about axes of the carrier or of the
// joint but for noise, or about any axis.
model::KinematicTree with_ill_rotors(model::KinematicTree robot, std::uint64_t seed);

}  // namespace robcogen::numeric
