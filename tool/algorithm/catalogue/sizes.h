// How long the code of large robots is.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// Pairs of a coordinate and one that carries it, those of a floating base too.
long pairs_of_coordinates(const model::KinematicTree& tree);

// Operations of the solutions in derivatives of forward dynamics: a product and a sum, there and back, for each such
// pair, and each right-hand side.
long operations_of_solutions(const model::KinematicTree& tree);

// The same of the solutions for the acceleration of a base that nothing holds, in derivatives of inverse dynamics: a
// solution of six rows, and six products and sums a joint, for each right-hand side.
long operations_of_base_solutions(const model::KinematicTree& tree);

// Whether so many, without a loop, would outgrow the caches for instructions.
bool are_long_solutions(long operations);

// Whether they are better in a loop over right-hand sides in lanes.
bool solves_in_columns(const model::KinematicTree& tree);
bool solves_for_base_in_columns(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
