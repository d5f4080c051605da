// Linear systems with a symmetric positive definite matrix, by factorisation without square roots.
#pragma once

#include <functional>
#include <vector>

#include "algorithm/spatial/vectors.h"

namespace robcogen::algorithm {

// The factors of A = L^T D L: the elements of L below its diagonal of ones, and the reciprocals of D.
struct LdlFactors {
  SquareMatrix l;
  std::vector<Expression> inverse_d;
};

// Eliminates from the last row up; zeros of A cost nothing. (Featherstone 2008, sec. 6.5.) `names`: of the rows, for
// the factors and what is left of A. Calls row(k) before row k is eliminated, and element(k, i, l) when its elimination
// has reached row i.
LdlFactors ldl_factors(
    SquareMatrix a,
    const std::vector<std::string>& names,
    const std::function<void(int k)>& row = {},
    const std::function<void(int k, int i, const Expression& l)>& element = {});

// Solves A x = b. `names` also names b and x.
std::vector<Expression> solve(SquareMatrix a, std::vector<Expression> b, const std::vector<std::string>& names);
// The same for many b, each with a name of its own.
struct RightSide {
  std::string name;
  std::vector<Expression> b;
};
std::vector<std::vector<Expression>> solve(
    SquareMatrix a,
    std::vector<RightSide> right,
    const std::vector<std::string>& names);

// The halves of a solution: y = L^-T b, and x = L^-1 D^-1 y.
std::vector<Expression> first_half(const LdlFactors& factors, std::vector<Expression> b);
std::vector<Expression> second_half(const LdlFactors& factors, const std::vector<Expression>& y);

}  // namespace robcogen::algorithm
