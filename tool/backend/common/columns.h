// Functions that loop over right-hand sides (Function::solved): the pieces that languages print.
#pragma once

#include "backend/common/lower.h"
#include "backend/library.h"
#include "symbolic/cost.h"

namespace robcogen::backend {

// The function that computes the right-hand sides.
const Function& right_sides(const Library& library, const Function& function);

// The solution of one column, as an internal function of the library.
Function column_solution(const symbolic::SolvedColumns& solved);

// The kernel of such a function. It has no lines, only parameters, all marked as used.
Kernel without_lines(const Function& function, const Dialect& dialect);

// The operations of a function; for a loop, those of all columns together.
symbolic::Cost count(const Library& library, const Function& function);

}  // namespace robcogen::backend
