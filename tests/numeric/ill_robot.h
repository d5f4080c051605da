// Robots with deliberately ill-conditioned numbers, where a careless generator loses digits.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::numeric {

// A random tree of 1 to 12 joints; half of the robots have a floating base. Axes are parallel or at right angles up to
// 10^-1 … 10^-17 rad, or up to the digits of PI that documents write; centres of mass and products of inertia are as
// small as 1e-18 and 1e-12; prismatic joints follow revolute ones; in some robots offsets and masses span 12 decades.
// The robot depends only on the seed, on every platform.
model::KinematicTree ill_robot(std::uint64_t seed);

// Adds rotors to most joints of the robot, carried by any links with mass. Their axes are those of the carrier or of
// the joint up to noise, or arbitrary.
model::KinematicTree with_ill_rotors(model::KinematicTree robot, std::uint64_t seed);

}  // namespace robcogen::numeric
