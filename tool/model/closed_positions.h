// Where joints are that follow through loops which no formulas close.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// The positions of followers_in_q(), in their order, where the elements of q have these values; `q` may have those of
// followers, too, which are not read. Loops are followed on a straight way from where they are assembled; positions in
// which they do not close are not numbers.
std::vector<double> closed_followers(
    const KinematicTree& tree,
    const std::vector<double>& q,
    const std::vector<double>& parameters);

}  // namespace robcogen::model
