// A scalar of the standard library and its functions.
#pragma once

#include <iit/rbd/rbd.h>

#include <cmath>

namespace iit::rbd {

template <class SCALAR>
struct ScalarTrait {
  using Scalar = SCALAR;
  static Scalar sin(const Scalar& x) { return std::sin(x); }
  static Scalar cos(const Scalar& x) { return std::cos(x); }
  static Scalar tan(const Scalar& x) { return std::tan(x); }
  static Scalar sinh(const Scalar& x) { return std::sinh(x); }
  static Scalar cosh(const Scalar& x) { return std::cosh(x); }
  static Scalar tanh(const Scalar& x) { return std::tanh(x); }
  static Scalar exp(const Scalar& x) { return std::exp(x); }
  static Scalar fabs(const Scalar& x) { return std::fabs(x); }
  static Scalar sqrt(const Scalar& x) { return std::sqrt(x); }
  template <int kRows, int kColumns>
  static PlainMatrix<Scalar, kColumns, 1> solve(
      const PlainMatrix<Scalar, kRows, kColumns>& A,
      const PlainMatrix<Scalar, kRows, 1>& b) {
    return A.partialPivLu().solve(b);
  }
};

}  // namespace iit::rbd
