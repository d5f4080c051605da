// Congruent limbs in the lanes of vectors, for each function in the formulation for which that is fastest.
#pragma once

#include "driver/candidates.h"

namespace robcogen::driver {

// Packs congruent limbs into lanes for the functions that this makes faster, and that keep their digits.
Functions pack_lanes(const Robot& robot, Functions functions, Formulations& formulations, const Passes& passes);

}  // namespace robcogen::driver
