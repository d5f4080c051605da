// What the self-check of a robot's library in C needs: the headers of the same library in C++, and a unit that computes
// its kernels by the functions in C. The checks, which are written over the library in C++, then check the one in C.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend::selfcheck {

// The files, as paths below the folder of the library in C. They depend on the arguments alone.
std::vector<std::string> outputs(const std::string& name, const std::string& enclosing);

// Prints selfcheck/<name>/kernels.cpp and the headers that it and the checks include. `library` is that of the language
// C: a robot.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::selfcheck
