// Cuts a long program into stages that run one after the other, for processors whose threads have few registers.
//
// A value that later stages read is either passed through the workspace or computed there again, whichever takes less
// time: memory limits the kernels of GPUs, so a number that is passed costs as much as dozens of instructions.
#pragma once

#include "symbolic/solved_columns.h"
#include "symbolic/stages.h"

namespace robcogen::symbolic {

// Stages of at most `longest` statements, not counting those that are computed again. Every result is that of the
// program, to the last bit. Programs with lanes are not cut.
Stages cut_program(const Program& program, int longest);

// The same for a function that solves for columns: `right_sides` is cut, and the last stages solve for a few columns at
// a time, which share the numbers of the factor. `solved`: the blocks and the solution.
Stages cut_program(const Program& right_sides, const SolvedColumns& solved, int longest);

}  // namespace robcogen::symbolic
