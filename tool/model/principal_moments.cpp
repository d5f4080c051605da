#include "model/principal_moments.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robcogen::model {

// Uses cyclic Jacobi rotations (Golub and Van Loan, 8.5).
std::array<double, 3> principal_moments(SymmetricMatrix a) {
  constexpr int kSweeps = 12;  // quadratic convergence: five are enough for doubles
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
      if (a[p][q] == 0.0) continue;
      const double tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
      const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::hypot(1.0, tau));
      const double c = 1.0 / std::hypot(1.0, t), s = t * c;
      for (std::size_t k = 0; k < 3; ++k) {
        const double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
      }
    }
  }
  std::array<double, 3> values = {a[0][0], a[1][1], a[2][2]};
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace robcogen::model
