// The smallest back end: it has no language and lists its input.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::null {

// <name>.txt: a line for each function, with the sizes of inputs and outputs, and how many statements there
// are.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::null
