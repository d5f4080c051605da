// Elements of arrays that lanes come from or go to and that stand side by side: what moves as whole vectors.
#pragma once

#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Lane i of column k is element first + i * stride + k of an array.
struct Block {
  int array = 0;  // into Program::outputs or Program::inputs
  int first = 0;
  int stride = 0;
  int width = 0;                 // lanes
  std::vector<Operand> columns;  // values of so many lanes, or constants, which are the same in all
};

// Elements of an output, side by side, that are the same constant, but for some in between: these are written later.
struct Fill {
  int array = 0;
  int first = 0;
  int count = 0;
  Operand value;
};

struct Stores {
  std::vector<Block> blocks;
  std::vector<Fill> fills;
};

// What outputs of a program with lanes are written as, of two columns or more; of one without lanes, nothing. Elements
// that belong to neither are written one by one.
Stores stores(const Program& program);

// Gathers, two or more, that are columns of a block of an input.
std::vector<Block> loads(const Program& program);

// Instructions that put a block together from its columns, or take it apart, beside those that load or store.
int moves(const Block& block);

}  // namespace robcogen::symbolic
