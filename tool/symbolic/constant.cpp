#include "symbolic/constant.h"

#include <cmath>

namespace robcogen::symbolic {

Constant Constant::folded_as(double representative) const {
  Constant result(number_);
  if (representative != value() && std::isfinite(representative)) result.representative_ = representative;
  return result;
}

Constant operator-(const Constant& a) {
  return a.folds_as_itself() ? Constant(-a.number_) : Constant(-a.number_).folded_as(-a.representative());
}

Constant operator+(const Constant& a, const Constant& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const Constant sum(a.number_ + b.number_);
  if (a.folds_as_itself() && b.folds_as_itself()) return sum;
  return sum.folded_as(a.representative() + b.representative());
}

Constant operator*(const Constant& a, const Constant& b) {
  if (a.is_zero() || b.is_zero()) return Constant();
  const Constant product(a.number_ * b.number_);
  if (a.folds_as_itself() && b.folds_as_itself()) return product;
  return product.folded_as(a.representative() * b.representative());
}

Constant operator/(const Constant& a, const Constant& b) {
  const Constant quotient(a.number_ / b.number_);
  if (a.folds_as_itself() && b.folds_as_itself()) return quotient;
  return quotient.folded_as(a.representative() / b.representative());
}

}  // namespace robcogen::symbolic
