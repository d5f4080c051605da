// Loops of generated functions over the right-hand sides of a linear system, one right-hand side in each lane.
#pragma once

#include <type_traits>
#include <utility>

#include "robcogen/batch_body.h"

namespace robcogen {
namespace {  // separate in each file, like lanes

// Solves a system of kRows equations, given the kFactor numbers of a factor of its matrix, and replaces the columns of
// right-hand sides by their solutions. `solve_one(factor, b, x)` solves for one column of any scalar type.
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
  static constexpr int kRowCount = kRows;
  using Number = Scalar;

  explicit ColumnSolver(const Scalar* factor) noexcept { batch::spread(factor, kFactor, factor_); }

  const NativeLanes<Scalar>* factor() const noexcept { return factor_; }

  template <class Solve>
  void solve(Scalar* columns, int count, Solve solve_one) const noexcept {
    int c = 0;
    for (; c + kSize <= count; c += kSize) solve_block(columns + c * kRows, solve_one);
    if (c == count) return;
    // The last columns do not fill a block.
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

  // Solves for one column in each lane.
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

// Makes a matrix exactly symmetric, whose columns were solved for one by one: the upper triangle becomes the lower one.
template <int kRows, class Scalar>
void mirror_lower(Scalar* matrix) noexcept {
  for (int c = 1; c < kRows; ++c)
    for (int r = 0; r < c; ++r) matrix[c * kRows + r] = matrix[r * kRows + c];
}

// Whether one number from each limb, kLimbs in all, fills a register.
template <class Scalar, int kLimbs>
constexpr bool kFillsLanes = kPrefersLanes<Scalar>&& lanes::kInRegister<Scalar> == kLimbs;

// Solves for the columns of congruent limbs: for one joint after the other, the columns of this joint in all limbs
// together. A column is zero in the rows of the other limbs. Each limb has kJoints rows and columns, one limb after
// another; the rows and columns that the limbs have in common precede them. kPlaces are the indices of the limbs'
// numbers in the factor: kOwn numbers, each for the first limb and then for the others.
template <int kLimbs, int kJoints, int kOwn, class Solver>
class LimbSolver {
  using Scalar = typename Solver::Number;
  using Value = NativeLanes<Scalar>;
  static constexpr int kRows = Solver::kRowCount, kCommon = kRows - kLimbs * kJoints;
  using Limbs = std::make_integer_sequence<int, kLimbs>;

 public:
  template <short... kPlaces>
  LimbSolver(const Solver& solver, const Scalar* factor, std::integer_sequence<short, kPlaces...>) noexcept
      : factor_(solver.factor()) {
    constexpr short own[] = {kPlaces...};
    static_assert(sizeof...(kPlaces) == kOwn * kLimbs, "a place for each number of each limb");
    for (int i = 0; i < kOwn; ++i) own_[i] = picked(factor, own + i * kLimbs, Limbs());
    for (int i = 0; i < kLimbs; ++i) is_limb_[i] = one_at(i, Limbs());
  }

  // `solve_one(factor, own, is_limb, b, x)` solves for one column of each limb.
  template <class Solve>
  void solve(Scalar* columns, Solve solve_one) const noexcept {
    constexpr std::ptrdiff_t kNextLimb = kJoints * kRows;
    const batch::Block<Scalar> block(kLimbs);
    for (int joint = 0; joint < kJoints; ++joint) {
      Scalar* const first = columns + joint * kRows;
      Value b[kCommon + kJoints], x[kRows];
      block.template load<kCommon>(batch::Strided<const Scalar>{first, 1, kNextLimb}, b);
      block.template load<kJoints>(batch::Strided<const Scalar>{first + kCommon, 1, kNextLimb + kJoints}, b + kCommon);
      solve_one(
          factor_, static_cast<const Value*>(own_), static_cast<const Value*>(is_limb_), static_cast<const Value*>(b),
          x);
      block.template store<kRows>(x, batch::Strided<Scalar>{first, 1, kNextLimb});
    }
  }

 private:
  const Value* factor_;
  Value own_[kOwn], is_limb_[kLimbs];

  template <int... kLimb>
  static Value picked(const Scalar* factor, const short* places, std::integer_sequence<int, kLimb...>) noexcept {
    return Value::of(factor[places[kLimb]]...);
  }
  template <int... kLimb>
  static Value one_at(int limb, std::integer_sequence<int, kLimb...>) noexcept {
    return Value::of(Scalar(kLimb == limb ? 1 : 0)...);
  }
};

}  // namespace
}  // namespace robcogen
