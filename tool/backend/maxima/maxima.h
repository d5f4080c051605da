// Maxima: symbolic text that keeps every variable.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::maxima {

// <prefix>_<group>.mac for each group, with the functions <prefix>_<kernel>; the prefix is the library's name, after
// its enclosing namespaces. Loading a file defines functions and nothing else. Vectors are lists, of numbers or of
// anything symbolic; matrices are matrices; several results are a list of these. Exact constants are integers,
// fractions and fractions of %pi, all others floats. A parametric robot's functions take the list of its parameters
// first.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::maxima
