// Linear systems with a symmetric positive definite matrix, by factors without square roots.
#pragma once

#include <vector>

#include "algorithm/spatial/vectors.h"

namespace robcogen::algorithm {

// Solutions of A x = b, by A = L^T D L from the last row up: zeros of A cost nothing. (Featherstone 2008, sec. 6.5.)
// `names` of the rows: of factors, what is left of A, b and x.
std::vector<Expression> solve(SquareMatrix a, std::vector<Expression> b, const std::vector<std::string>& names);
// For many b, each with a name of its own.
struct RightSide {
  std::string name;
  std::vector<Expression> b;
};
std::vector<std::vector<Expression>> solve(
    SquareMatrix a,
    std::vector<RightSide> right,
    const std::vector<std::string>& names);

}  // namespace robcogen::algorithm
