// A function whose results are solutions of one linear system for many right-hand sides, as a loop over them instead of
// code for each.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

struct SolvedColumns {
  // Has the function's inputs, and its outputs with right-hand sides in place of the solutions. The last output is
  // `factor`, with which the system is solved.
  Program right_sides;
  // Solves one column: inputs `factor` and `b`, output `x`.
  Program solution;

  // The first columns of an output, which are solutions.
  struct Block {
    int output = 0;
    int columns = 0;
    bool of_limbs = false;  // with Limbs: a column for each joint of each limb, zero in the rows of other limbs
  };
  std::vector<Block> blocks;
  bool is_long = false;  // without the loop, the code would be too long for compilers and instruction caches

  // Limbs of equal structure, whose rows and columns follow one after another, behind the rows that they have in
  // common. One column of each limb is solved at a time, each limb in its own lane.
  struct Limbs {
    int count = 0;
    int joints = 0;  // of each
    // Elements of the factor that belong to limbs: each one of the first limb, followed by its counterparts.
    std::vector<int> own;
    // Inputs: `factor`; `own`, the elements of the lane's limb; `is_limb`, one for that limb and zero for others; `b`,
    // the common rows and those of the limb. Output: `x`, all rows.
    Program solution;
  };
  std::optional<Limbs> limbs = {};

  // Makes the outputs of these names blocks, in the order of the outputs: all of their columns, or the first `columns`.
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
