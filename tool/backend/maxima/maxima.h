// Maxima: symbolic text that keeps every variable.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::maxima {

// Prints <robot>.mac with the functions <robot>_<kernel>, where <robot> is the library's name after its enclosing
// namespaces. Loading it defines functions and nothing else. Vectors are lists of numbers or of symbolic expressions,
// matrices are Maxima matrices, and several results are a list. Exact constants are integers, fractions and fractions
// of %pi; all others are floats. The functions of a library with parameters take the list of parameters first;
// <robot>_parameters() returns the list of their defaults.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::maxima
