// Neighbouring elements of arrays that are loaded into lanes, or stored from them, as whole vectors.
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
  std::vector<Operand> columns;  // values with that many lanes, or constants, which are equal in all lanes
};

// Neighbouring elements of an output that equal one constant. Elements in between may differ: they are written later.
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

// The blocks (of two columns or more) and fills that store the outputs of a program with lanes; none for a program
// without lanes. Other elements are stored one by one.
Stores stores(const Program& program);

// The blocks of inputs whose columns are two or more gathers.
std::vector<Block> loads(const Program& program);

// The number of instructions that assemble a block from its columns or split it into them, not counting loads and
// stores.
int moves(const Block& block);

}  // namespace robcogen::symbolic
