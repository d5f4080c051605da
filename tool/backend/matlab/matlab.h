// MATLAB and Octave: a package folder with one function a file.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::matlab {

// +<name>/<function>.m for the functions of all groups, scopes as packages in it (+transforms/+homogeneous/…),
// +<name>/model.m with the constants of a robot, and +<name>/Contents.m, an overview.
//
// Vectors are columns, matrices are full. Overloads are one function: external wrenches may be left out, and gravity
// where the base is fixed. Every function refuses missing arguments and those of another shape. Where there are
// parameters, a struct of them is the first argument of what depends on them; +<name>/parameters.m returns their
// declared values. Variables of a document with no robot are arguments one by one, by their names, after the parameters
// and in the order of the document. Everything runs in both programs unchanged.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::matlab
