// A loop of generated functions over the right-hand sides of a linear system, one in each lane.
#pragma once

#include "robcogen/batch_body.h"

namespace robcogen {
namespace {  // separate in each file, like lanes

// Solves a system of kRows equations for columns of a matrix, which it replaces, with the kFactor numbers of a factor.
// `solve(factor, b, x)` solves for one column of any scalar type.
template <int kRows, int kFactor, class Scalar, bool kHasLanes = kPrefersLanes<Scalar>>
class ColumnSolver {
 public:
  explicit ColumnSolver(const Scalar* factor) noexcept : factor_(factor) {}

  template <class Solve>
  void solve(Scalar* columns, int count, Solve solve_one) const noexcept {
    for (int c = 0; c < count; ++c) {
      Scalar b[kRows];
      for (int r = 0; r < kRows; ++r) b[r] = columns[c * kRows + r];
      solve_one(factor_, static_cast<const Scalar*>(b), columns + c * kRows);
    }
  }

 private:
  const Scalar* factor_;
};

template <int kRows, int kFactor, class Scalar>
class ColumnSolver<kRows, kFactor, Scalar, true> {
 public:
  explicit ColumnSolver(const Scalar* factor) noexcept { batch::spread(factor, kFactor, factor_); }

  template <class Solve>
  void solve(Scalar* columns, int count, Solve solve_one) const noexcept {
    const batch::Strided<const Scalar> from{columns, 1, kRows};
    const batch::Strided<Scalar> to{columns, 1, kRows};
    for (batch::Block<Scalar> block(count); block.is_left(); block.advance()) {
      Value b[kRows], x[kRows];
      block.template load<kRows>(from, b);
      solve_one(factor_, static_cast<const Value*>(b), x);
      block.template store<kRows>(x, to);
    }
  }

 private:
  using Value = NativeLanes<Scalar>;
  Value factor_[kFactor];
};

}  // namespace
}  // namespace robcogen
