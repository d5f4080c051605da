// The smallest back end: it has no language and lists its input.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::null {

// Prints <name>.txt: a line for each function with the sizes of its inputs and outputs and its number of statements.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::null
