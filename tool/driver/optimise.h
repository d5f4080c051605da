// From programs to cheaper programs, in the forms that a language takes.
#pragma once

#include "driver/functions.h"
#include "driver/load.h"
#include "driver/steps.h"

namespace robcogen::driver {

// Runs, as far as the steps and the language ask for them and in this order: the passes, the split of parameters,
// congruent limbs in lanes, the split of sines and cosines.
Functions optimise(const Model& model, Functions functions, const Steps& steps, const backend::Features& features);

}  // namespace robcogen::driver
