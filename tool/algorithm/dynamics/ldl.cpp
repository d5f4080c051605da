#include "algorithm/dynamics/ldl.h"

namespace robcogen::algorithm {

std::vector<Expression> solve(SquareMatrix a, std::vector<Expression> b) {
  const int n = a.size();
  std::vector<Expression> inverse_d(at(n));
  SquareMatrix l(n);
  for (int k = n; k-- > 0;) {
    inverse_d[at(k)] = a(k, k).graph()->one() / a(k, k);
    for (int i = 0; i < k; ++i) l(k, i) = a(k, i) * inverse_d[at(k)];
    for (int i = 0; i < k; ++i) {
      for (int j = 0; j <= i; ++j) a(i, j) -= l(k, i) * a(k, j);
      b[at(i)] -= l(k, i) * b[at(k)];
    }
  }
  std::vector<Expression> x(at(n));
  for (int k = 0; k < n; ++k) {
    x[at(k)] = b[at(k)] * inverse_d[at(k)];
    for (int i = 0; i < k; ++i) x[at(k)] -= l(k, i) * x[at(i)];
  }
  return x;
}

}  // namespace robcogen::algorithm
