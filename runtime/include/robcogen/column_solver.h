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
    int c = 0;
    for (; c + kSize <= count; c += kSize) solve_block(columns + c * kRows, solve_one);
    if (c == count) return;
    // The last ones fill no block.
    Scalar block[kSize * kRows] = {};
    Scalar* const last = columns + c * kRows;
    const int numbers = (count - c) * kRows;
    for (int k = 0; k < numbers; ++k) block[k] = last[k];
    solve_block(block, solve_one);
    for (int k = 0; k < numbers; ++k) last[k] = block[k];
  }

 private:
  using Value = NativeLanes<Scalar>;
  static constexpr int kSize = batch::Block<Scalar>::kSize;

  // As many columns as there are lanes.
  template <class Solve>
  void solve_block(Scalar* columns, Solve solve_one) const noexcept {
    const batch::Block<Scalar> block(kSize);
    Value b[kRows], x[kRows];
    block.template load<kRows>(batch::Strided<const Scalar>{columns, 1, kRows}, b);
    solve_one(factor_, static_cast<const Value*>(b), x);
    block.template store<kRows>(x, batch::Strided<Scalar>{columns, 1, kRows});
  }

  Value factor_[kFactor];
};

}  // namespace
}  // namespace robcogen
