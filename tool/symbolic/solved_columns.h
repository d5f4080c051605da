// A function whose results are solutions of one linear system for many right-hand sides: a loop over them in the place
// of code for each.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
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
    bool of_limbs = false;  // with Limbs: a column for each joint of each limb, zero in the rows of other limbs
  };
  std::vector<Block> blocks;
  bool is_long = false;  // without the loop, the code would be too long for compilers and for caches of instructions

  // Limbs of equal structure, one after another in rows and columns behind the rows that they have in common: a column
  // of each limb is solved at a time, one in each lane.
  struct Limbs {
    int count = 0;
    int joints = 0;  // of each
    // Elements of the factor: those of the first limb, each followed by its counterparts.
    std::vector<int> own;
    // Inputs `factor`; `own`, those of the lane's limb; `is_limb`, one for that limb and zero for others; `b`, common
    // rows and those of the limb. Output `x`, all rows.
    Program solution;
  };
  std::optional<Limbs> limbs = {};

  // Makes outputs of these names blocks, in their own order: all of their columns, or so many.
  struct NamedBlock {
    std::string_view output;
    int columns = -1;
  };
  void add_blocks(std::initializer_list<NamedBlock> named) {
    for (std::size_t k = 0; k < right_sides.outputs.size(); ++k)
      for (const NamedBlock& block : named)
        if (const OutputArray& array = right_sides.outputs[k]; array.name == block.output)
          blocks.push_back({static_cast<int>(k), block.columns < 0 ? array.columns : block.columns});
  }
};

}  // namespace robcogen::symbolic
