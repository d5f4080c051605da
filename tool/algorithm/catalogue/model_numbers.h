// The numbers of a parametric robot's model as a program, for independent checks.
#pragma once

#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

inline constexpr int kNumbersOfLink = 10, kNumbersOfPlacement = 6, kNumbersOfDrive = 11;

// parameters -> `links`, `joints`, `frames`: a column for each link, joint and frame of the tree (`frames()`), in
// order. Link: mass (kg), centre of mass (m), then moments of inertia xx yy zz and products xy xz yz of positive sign
// (kg m^2), in the axes of the link and about its origin. Joint and frame: translation (m), then rotation about the
// intrinsic axes x, y', z'' (rad), in the link that carries it. If any joint has a drive, all joints have the numbers
// of their drives next: damping, friction and its velocity, armature, stiffness, rest, then inertia, ratio and axis of
// the rotor. If any joint is helical, all joints have a pitch (m per radian) last.
symbolic::Program model_numbers(const model::KinematicTree& tree);

// parameters -> `couplings`: a column for each coupled joint: its factors, a row for each coordinate, then its offset.
symbolic::Program coupling_numbers(const model::KinematicTree& tree);

// The numbers of tendons, a column for each: the factors of all joints, coupled ones last, then stiffness, damping and
// rest length.
symbolic::Program tendon_numbers(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
