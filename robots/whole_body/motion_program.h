// Least squares for accelerations of a robot and forces of the ground, subject to equations that must hold.
#pragma once

#include <Eigen/Core>

#include "nonnegative.h"

namespace whole_body {

// Sizes are known when the program runs, and bounded: nothing allocates, and one library serves all robots.
inline constexpr int kMaxCoordinates = 40, kMaxHeld = 24;
template <int kMaxRows, int kMaxColumns>
using Bounded = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxRows, kMaxColumns>;
template <int kMaxRows>
using BoundedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxRows, 1>;
using MatrixView = Eigen::Ref<const Bounded<kMaxCoordinates, kMaxCoordinates>, 0, Eigen::OuterStride<>>;
using VectorView = Eigen::Ref<const BoundedVector<kMaxCoordinates>>;

// Minimises the sum of w |J a - b|^2 / 2 over tasks, plus a small multiple of |x|^2 / 2, subject to
// A a = right + (D x, 0) and x >= 0. D has fewer rows than A.
class MotionProgram {
 public:
  MotionProgram(int coordinates, int held);

  void add_task(double weight, const MatrixView& J, const VectorView& b);
  // The same for the last coordinates themselves.
  void add_task(double weight, const VectorView& b);

  // Sets rows of `A a = right` from row `first` on. A row that is not set holds for any a.
  void hold(int first, const MatrixView& A, const VectorView& right);
  void add_to_right(int first, const VectorView& more) { right_.segment(first, more.size()) += more; }

  struct Solution {
    BoundedVector<kMaxCoordinates> a;
    bool is_best;  // false: x is feasible, but the optimum was not found in time
  };
  // Starts from x, and changes it to the optimum.
  Solution solve(const MatrixView& D, double weight_of_x, NonnegativeVector& x) const;

 private:
  Bounded<kMaxCoordinates, kMaxCoordinates> squares_;  // sum of w J' J
  BoundedVector<kMaxCoordinates> target_;              // sum of w J' b
  Bounded<kMaxHeld, kMaxCoordinates> A_;
  BoundedVector<kMaxHeld> right_, open_;
};

}  // namespace whole_body
