// Checks the internal consistency of a program.
#pragma once

#include <string>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Operands come before their users, indices are in range, names are unique identifiers and not names of operations,
// constants are finite and not negative, output sizes are right. Returns the first fault, or an empty text.
std::string verify(const Program& program);

// The number of lanes of a statement that follows from its operands.
int width_of_result(const Program& program, const Statement& s);

}  // namespace robcogen::symbolic
