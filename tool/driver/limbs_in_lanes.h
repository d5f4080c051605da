// Congruent limbs in the lanes of vectors, for each function in the formulation for which that is fastest.
#pragma once

#include "driver/candidates.h"

namespace robcogen::driver {

// Packs congruent limbs into lanes if this makes the function faster, and if it keeps its digits. Nothing changes if
// that has been tried.
void pack_lanes(const Robot& robot, Function& function, Formulations& formulations, const Passes& passes);

}  // namespace robcogen::driver
