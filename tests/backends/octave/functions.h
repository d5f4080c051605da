// What a function of a library looks like to Octave.
#pragma once

#include "backend/library.h"
#include "calls.h"

namespace robcogen::octave {

// The function's package name, arguments and results; nothing that evaluates it.
Call shape(const backend::Library& library, const backend::Function& function);

// Whether the last argument is gravity, and no overload does without it.
bool may_omit_gravity(const backend::Library& library, const backend::Function& function);

}  // namespace robcogen::octave
