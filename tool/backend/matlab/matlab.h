// MATLAB and Octave: a package folder with one function a file.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::matlab {

// +<name>/<function>.m for the functions of all groups, scopes as packages in it (+transforms/+homogeneous/…), and
// +<name>/model.m with the robot's constants. Vectors are columns, matrices are full; overloads are one function whose
// last arguments may be left out. A parametric robot's functions take a struct of its parameters first, whose defaults
// +<name>/parameters.m returns. Everything runs in both programs unchanged.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::matlab
