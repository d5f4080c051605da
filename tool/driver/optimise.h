// From programs to cheaper programs, in the forms that a language takes.
#pragma once

#include "driver/functions.h"
#include "driver/load.h"
#include "driver/steps.h"

namespace robcogen::driver {

// In this order: the passes, parameters split off, congruent limbs in lanes, sines and cosines split off; those that
// the steps and the language ask for.
Functions optimise(const Model& model, Functions functions, const Steps& steps, const backend::Features& features);

}  // namespace robcogen::driver
