// A function whose results are solutions of one linear system for many right-hand sides: a loop over them in the place
// of code for each.
#pragma once

#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

struct SolvedColumns {
  // Of the function's inputs: its outputs, with right-hand sides in the place of solutions, and last `factor`, what
  // the system is solved with.
  Program right_sides;
  // One column: inputs `factor` and `b`, output `x`.
  Program solution;

  // The columns of an output that are solutions, the first ones.
  struct Block {
    int output = 0;
    int columns = 0;
  };
  std::vector<Block> blocks;
};

}  // namespace robcogen::symbolic
