// The size of the code of large robots.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::algorithm {

// The number of pairs of a coordinate and one that carries it, including those of a floating base.
long pairs_of_coordinates(const model::KinematicTree& tree);

// The number of operations of the solutions in derivatives of forward dynamics: a product and a sum, forward and back,
// for each such pair and each right-hand side.
long operations_of_solutions(const model::KinematicTree& tree);

// The same for the inverse of the joint-space inertia matrix: a right-hand side per row.
long operations_of_inverse(const model::KinematicTree& tree);

// The same for the acceleration of an unactuated base in derivatives of inverse dynamics: a solution of six rows, and
// six products and sums per joint, for each right-hand side.
long operations_of_base_solutions(const model::KinematicTree& tree);

// The same for derivatives of forward dynamics with contacts, whose rows and columns are in addition those of the
// contacts.
long operations_of_contact_solutions(
    const model::KinematicTree& tree,
    const std::vector<model::ContactFrame>& contacts);

// Whether that many operations, without a loop, would exceed instruction caches.
bool are_long_solutions(long operations);

// Whether solutions are better in a loop over right-hand sides in lanes; the second for an unactuated base.
bool are_better_in_columns(long operations);
bool are_better_in_columns_for_base(long operations);

}  // namespace robcogen::algorithm
