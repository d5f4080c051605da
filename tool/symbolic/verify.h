// Whether a program is one.
#pragma once

#include <string>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Internal consistency: operands before users, indices in range, names unique, identifiers and no operation, constants
// finite and not negative, output sizes right.
// Empty when sound, else what is wrong first.
std::string verify(const Program& program);

// How many lanes follow from a statement's operands.
int width_of_result(const Program& program, const Statement& s);

}  // namespace robcogen::symbolic
