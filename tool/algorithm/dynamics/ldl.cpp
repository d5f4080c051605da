#include "algorithm/dynamics/ldl.h"

#include <utility>

#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {

LdlFactors ldl_factors(
    SquareMatrix a,
    const std::vector<std::string>& names,
    const std::function<void(int k)>& row,
    const std::function<void(int k, int i, const Expression& l)>& element) {
  const int n = a.size();
  LdlFactors factors{SquareMatrix(n), std::vector<Expression>(at(n))};
  SquareMatrix& l = factors.l;
  for (int k = n; k-- > 0;) {
    const std::string& name = names[at(k)];
    for (int i = 0; i <= k; ++i) described(coordinates("E", name, names[at(i)]), a(k, i));
    if (row) row(k);
    Expression& inverse_d = factors.inverse_d[at(k)];
    inverse_d = described(coordinate("D", name, "inv"), a(k, k).graph()->one() / a(k, k));
    for (int i = 0; i < k; ++i) {
      l(k, i) = described(coordinates("L", name, names[at(i)]), a(k, i) * inverse_d);
    }
    for (int i = 0; i < k; ++i) {
      for (int j = 0; j <= i; ++j) a(i, j) -= l(k, i) * a(k, j);
      if (element) element(k, i, l(k, i));
    }
  }
  return factors;
}

std::vector<Expression> solve(SquareMatrix a, std::vector<Expression> b, const std::vector<std::string>& names) {
  std::vector<RightSide> right;
  right.push_back({"", std::move(b)});
  return std::move(solve(std::move(a), std::move(right), names).front());
}

std::vector<std::vector<Expression>> solve(
    SquareMatrix a,
    std::vector<RightSide> right,
    const std::vector<std::string>& names) {
  const LdlFactors factors = ldl_factors(
      std::move(a), names,
      [&](int k) {
        for (const RightSide& side : right) described(coordinate("b", names[at(k)], side.name), side.b[at(k)]);
      },
      [&](int k, int i, const Expression& l) {
        for (RightSide& side : right) side.b[at(i)] -= l * side.b[at(k)];
      });
  std::vector<std::vector<Expression>> solutions;
  for (const RightSide& side : right) {
    solutions.push_back(second_half(factors, side.b));
    describe_elements("x", names, solutions.back(), side.name);
  }
  return solutions;
}

std::vector<Expression> first_half(const LdlFactors& factors, std::vector<Expression> b) {
  for (int k = factors.l.size(); k-- > 0;)
    for (int i = 0; i < k; ++i) b[at(i)] -= factors.l(k, i) * b[at(k)];
  return b;
}

std::vector<Expression> second_half(const LdlFactors& factors, const std::vector<Expression>& y) {
  const int n = factors.l.size();
  std::vector<Expression> x(at(n));
  for (int k = 0; k < n; ++k) {
    x[at(k)] = y[at(k)] * factors.inverse_d[at(k)];
    for (int i = 0; i < k; ++i) x[at(k)] -= factors.l(k, i) * x[at(i)];
  }
  return x;
}

}  // namespace robcogen::algorithm
