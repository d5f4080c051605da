// What a program would cost, from the graph that it is traced in: for those that are only compared.
#pragma once

#include <vector>

#include "symbolic/expression.h"

namespace robcogen::symbolic {

struct Weight {
  int work = 0;  // as count.h has it, of a program without parameters
  long statements = 0;
  double largest_constant = 0.0;
};

// Of the program with these outputs.
Weight weight(const Graph& graph, const std::vector<std::vector<Expression>>& outputs);

}  // namespace robcogen::symbolic
