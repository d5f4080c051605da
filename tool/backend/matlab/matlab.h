// MATLAB and Octave: a package folder with one function per file.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::matlab {

// Prints +<name>/<function>.m for the functions of all groups, with scopes as packages in it
// (+transforms/+homogeneous/…), +<name>/model.m with the constants of a robot, and +<name>/Contents.m, an overview.
//
// Vectors are columns, matrices are full. Overloads are one function: external wrenches may be left out, and gravity
// too if the base is fixed. Every function refuses missing arguments and arguments of another shape. If there are
// parameters, a struct of them is the first argument of every function that depends on them; +<name>/parameters.m
// returns their declared values. The variables of a document without a robot are separate arguments under their own
// names, after the parameters and in the order of the document. All files run unchanged in both programs.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::matlab
