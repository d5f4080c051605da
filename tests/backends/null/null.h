// The least that is a back end: it knows no language and lists what it receives.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::null {

// <name>.txt: a line for each function, with the sizes of what goes in and comes out, and how many statements there
// are.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::null
