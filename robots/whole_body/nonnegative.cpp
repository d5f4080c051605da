#include "nonnegative.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

namespace whole_body {
namespace {

using Index = Eigen::Index;

// The variables that are free; the others are zero.
struct FreeSet {
  std::array<Index, kMaxVariables> at;
  Index size = 0;

  void add(Index variable) { at[static_cast<std::size_t>(size++)] = variable; }
  bool has(Index variable) const { return std::find(at.begin(), at.begin() + size, variable) != at.begin() + size; }
  template <class Condition>
  void remove_if(const Condition& condition) {
    size = std::remove_if(at.begin(), at.begin() + size, condition) - at.begin();
  }
  Index operator[](Index k) const { return at[static_cast<std::size_t>(k)]; }
};

// The point at which the gradient of the free variables vanishes.
NonnegativeVector solution(const NonnegativeMatrix& Q, const NonnegativeVector& c, const FreeSet& free) {
  NonnegativeMatrix part(free.size, free.size);
  NonnegativeVector right(free.size);
  for (Index i = 0; i < free.size; ++i) {
    right[i] = c[free[i]];
    for (Index k = 0; k < free.size; ++k) part(i, k) = Q(free[i], free[k]);
  }
  part.llt().solveInPlace(right);
  NonnegativeVector x = NonnegativeVector::Zero(c.size());
  for (Index i = 0; i < free.size; ++i) x[free[i]] = right[i];
  return x;
}

}  // namespace

int minimise_nonnegative(const NonnegativeMatrix& Q, const NonnegativeVector& c, NonnegativeVector& x) {
  // A gradient this small is rounding.
  const double tolerance = 1e-9 * (c.cwiseAbs().maxCoeff() + 1e-300);
  FreeSet free;
  for (Index i = 0; i < x.size(); ++i)
    if (x[i] > 0) free.add(i);
  for (int solved = 1; solved <= 4 * kMaxVariables; ++solved) {
    const NonnegativeVector wanted = solution(Q, c, free);
    if (wanted.minCoeff() < 0) {
      // Moves in that direction as far as all variables stay positive; a variable that becomes zero is no longer free.
      double step = 1;
      for (Index i = 0; i < free.size; ++i)
        if (const Index k = free[i]; wanted[k] < 0) step = std::min(step, x[k] / (x[k] - wanted[k]));
      x += step * (wanted - x);
      free.remove_if([&](Index k) { return wanted[k] < 0 && x[k] <= 1e-12 * (wanted.cwiseAbs().maxCoeff()); });
      for (Index k = 0; k < x.size(); ++k)
        if (!free.has(k)) x[k] = 0;
      continue;
    }
    x = wanted;
    const NonnegativeVector descent = c - Q * x;
    Index best = -1;
    for (Index k = 0; k < x.size(); ++k)
      if (descent[k] > (best < 0 ? tolerance : descent[best]) && !free.has(k)) best = k;
    if (best < 0) return solved;
    free.add(best);
  }
  return -1;
}

}  // namespace whole_body
