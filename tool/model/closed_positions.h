// The positions of joints that follow through loops which no formulas close.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Returns the positions (rad, m) of followers_in_q(), in that order, at the given elements of q. `q` may include the
// positions of the followers themselves, which are not read. Each loop is tracked along a straight line in joint space,
// from the position in which it is assembled. The result is NaN where loops do not close.
std::vector<double> closed_followers(
    const KinematicTree& tree,
    const std::vector<double>& q,
    const std::vector<double>& parameters);

}  // namespace robcogen::model
