// The values of a program that are constant between two changes of its parameters.
#pragma once

#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// By statement: whether it depends on parameters and constants alone. False for all if the program has no parameters.
std::vector<char> follow_from_parameters(const Program& program);

}  // namespace robcogen::symbolic
