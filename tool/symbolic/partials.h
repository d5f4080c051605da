// Partial derivatives of single operations (Griewank and Walther 2008, ch. 3).
#pragma once

#include <cstddef>
#include <functional>

#include "symbolic/expression.h"

namespace robcogen::symbolic {

// The derivatives of an operation by its operands; the second one is computed on demand.
struct Partials {
  Expression a;
  std::function<Expression()> b;
};

// The partial derivatives of a node, which must be an operation.
Partials partials(Graph& graph, std::size_t node);

}  // namespace robcogen::symbolic
