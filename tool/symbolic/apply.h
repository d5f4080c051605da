// An operation on two scalars of any kind: numbers in the interpreter, expressions in the passes.
#pragma once

#include <cmath>
#include <stdexcept>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// `b` is ignored by unary operations.
template <class Scalar>
Scalar apply(Op op, const Scalar& a, const Scalar& b) {
  using std::atan2, std::cos, std::sin, std::sqrt;
  switch (op) {
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::square_root:
      return sqrt(a);
    case Op::sine:
      return sin(a);
    case Op::cosine:
      return cos(a);
    case Op::arc_tangent:
      return atan2(a, b);
    case Op::gather:
    case Op::sum_lanes:
      break;
  }
  throw std::logic_error("no operation on scalars");
}

}  // namespace robcogen::symbolic
