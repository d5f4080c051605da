// How long the code of large robots is.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// Pairs of a coordinate and one that carries it, those of a floating base too.
long pairs_of_coordinates(const model::KinematicTree& tree);

// Operations of the solutions in derivatives of forward dynamics: a product and a sum, there and back, for each such
// pair, and each right-hand side.
long operations_of_solutions(const model::KinematicTree& tree);

// Whether one after the other, without a loop, these would outgrow the caches for instructions.
bool needs_columns(const model::KinematicTree& tree);

// Whether they are better in a loop, where a language has one: right-hand sides in lanes are then faster.
bool solves_in_columns(const model::KinematicTree& tree);

// The same of the solutions for the acceleration of a base that nothing holds, in derivatives of inverse dynamics.
bool solves_for_base_in_columns(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
