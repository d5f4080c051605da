// Python: the source of an extension module over the library in C++, and the module's stub.
#pragma once

#include <vector>

#include "backend/library.h"

namespace robcogen::backend::python {

// Prints <name>.cpp, with tables and calls for <robcogen/python/make_module.h>, and <name>.pyi. The library must have
// been compiled in C++, with functions over many states if Library::has_batches says so.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::python
