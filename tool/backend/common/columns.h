// Functions that loop over right-hand sides (Function::solved): what languages print of them.
#pragma once

#include "backend/common/lower.h"
#include "backend/library.h"
#include "symbolic/count.h"

namespace robcogen::backend {

// The stage that such a function calls.
const Function& right_sides(const Library& library, const Function& function);

// The solution of one column, as a function of the library's own machinery.
Function column_solution(const symbolic::SolvedColumns& solved);

// Of such a function, which has no lines of its own: the parameters, all of them used.
Kernel without_lines(const Function& function, const Dialect& dialect);

// Of all columns together where it loops.
symbolic::OperationCount count(const Library& library, const Function& function);

}  // namespace robcogen::backend
