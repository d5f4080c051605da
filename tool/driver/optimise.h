// From declared functions to the cheapest programs, in the forms that a language takes.
#pragma once

#include "driver/functions.h"
#include "driver/load.h"
#include "driver/steps.h"

namespace robcogen::driver {

// Runs the choice among candidates, the split of parameters, congruent limbs in lanes, and the split of sines and
// cosines, in this order and as far as the steps and the language ask for them.
Functions optimise(const Model& model, Functions functions, const Steps& steps, const backend::Features& features);

}  // namespace robcogen::driver
