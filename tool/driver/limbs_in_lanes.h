// Congruent limbs in the lanes of vectors, for each function in the formulation for which that is fastest.
#pragma once

#include <vector>

#include "algorithm/formulation/congruent_limbs.h"
#include "driver/candidates.h"

namespace robcogen::driver {

// The half cycles in which the instructions of a program start: calls in a row do not wait for its critical path.
int starts(const symbolic::Program& program);

// Packs these congruent limbs of the robot into lanes if that makes the function faster, and if it keeps its digits.
// Nothing changes if that has been tried.
void pack_lanes(
    const Robot& robot,
    const std::vector<algorithm::LimbsInLanes>& limbs,
    Function& function,
    Formulations& formulations,
    const Passes& passes);

}  // namespace robcogen::driver
