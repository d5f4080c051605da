// Maxima: symbolic text that keeps every variable.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::maxima {

// <robot>.mac with the functions <robot>_<kernel>, where <robot> is the library's name after its enclosing namespaces.
// Loading it defines functions and nothing else. Vectors are lists, of numbers or of anything symbolic; matrices are
// matrices; several results are a list of these. Exact constants are integers, fractions and fractions of %pi, all
// others floats. A parametric library's functions take the list of its parameters first; <robot>_parameters() is that
// of their defaults.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::maxima
