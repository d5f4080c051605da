#include "algorithm/dynamics/ldl.h"

#include <utility>

#include "algorithm/spatial/describe.h"

namespace robcogen::algorithm {

std::vector<Expression> solve(SquareMatrix a, std::vector<Expression> b, const std::vector<std::string>& names) {
  std::vector<RightSide> right;
  right.push_back({"", std::move(b)});
  return std::move(solve(std::move(a), std::move(right), names).front());
}

std::vector<std::vector<Expression>> solve(
    SquareMatrix a,
    std::vector<RightSide> right,
    const std::vector<std::string>& names) {
  const int n = a.size();
  std::vector<Expression> inverse_d(at(n));
  SquareMatrix l(n);
  for (int k = n; k-- > 0;) {
    const std::string& row = names[at(k)];
    for (int i = 0; i <= k; ++i) describe(a(k, i), "E_" + row + "_" + names[at(i)]);
    for (const RightSide& side : right) describe(side.b[at(k)], "b_" + row + side.name);
    inverse_d[at(k)] = a(k, k).graph()->one() / a(k, k);
    describe(inverse_d[at(k)], "D_" + row + "_inv");
    for (int i = 0; i < k; ++i) {
      l(k, i) = a(k, i) * inverse_d[at(k)];
      describe(l(k, i), "L_" + row + "_" + names[at(i)]);
    }
    for (int i = 0; i < k; ++i) {
      for (int j = 0; j <= i; ++j) a(i, j) -= l(k, i) * a(k, j);
      for (RightSide& side : right) side.b[at(i)] -= l(k, i) * side.b[at(k)];
    }
  }
  std::vector<std::vector<Expression>> solutions;
  for (const RightSide& side : right) {
    std::vector<Expression>& x = solutions.emplace_back(at(n));
    for (int k = 0; k < n; ++k) {
      x[at(k)] = side.b[at(k)] * inverse_d[at(k)];
      for (int i = 0; i < k; ++i) x[at(k)] -= l(k, i) * x[at(i)];
      describe(x[at(k)], "x_" + names[at(k)] + side.name);
    }
  }
  return solutions;
}

}  // namespace robcogen::algorithm
