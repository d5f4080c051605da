// Partial derivatives of single operations (Griewank and Walther 2008, ch. 3).
#pragma once

#include <cstddef>
#include <functional>

#include "symbolic/expression.h"

namespace robcogen::symbolic {

// Of an operation by its operands; the second on demand.
struct Partials {
  Expression a;
  std::function<Expression()> b;
};

// Of a node that is an operation.
Partials partials(Graph& graph, std::size_t node);

}  // namespace robcogen::symbolic
