// A back end as small as one can be: the example of the guide.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::lua {

// Prints <name>.lua, a module of functions that take and return arrays.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::lua
