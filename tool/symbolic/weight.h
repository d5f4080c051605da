// The cost of a program, from the graph that it is traced in: for programs that are only compared.
#pragma once

#include <vector>

#include "symbolic/expression.h"

namespace robcogen::symbolic {

struct Weight {
  int work = 0;  // as defined in count.h, for a program without parameters
  long statements = 0;
  double largest_constant = 0.0;
};

// The weight of the program with these outputs.
Weight weight(const Graph& graph, const std::vector<std::vector<Expression>>& outputs);

}  // namespace robcogen::symbolic
