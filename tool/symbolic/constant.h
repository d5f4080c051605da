// A constant of a program, and of the graph that the program is traced in.
//
// A constant may stand for a set of numbers, such as the masses of four legs that differ by a gram, and fold as a
// representative number of the set does: it is zero, one, or equal to another constant only if both its own number and
// the representative one are. Sums, products and quotients compute both numbers.
#pragma once

#include <optional>

#include "support/number.h"

namespace robcogen::symbolic {

class Constant {
 public:
  Constant() = default;  // exactly zero
  Constant(const Number& number) : number_(number) {}

  // The same number, with this representative number of its set.
  Constant folded_as(double representative) const;

  const Number& number() const { return number_; }
  double value() const { return number_.value(); }
  double representative() const { return representative_.value_or(value()); }
  bool folds_as_itself() const { return !representative_; }
  bool is_zero() const { return value() == 0.0 && representative() == 0.0; }

  friend Constant operator-(const Constant& a);
  friend Constant operator+(const Constant& a, const Constant& b);
  friend Constant operator-(const Constant& a, const Constant& b) { return a + (-b); }
  friend Constant operator*(const Constant& a, const Constant& b);
  friend Constant operator/(const Constant& a, const Constant& b);
  friend bool operator==(const Constant&, const Constant&) = default;

 private:
  Number number_;
  std::optional<double> representative_;  // when it differs from the value
};

}  // namespace robcogen::symbolic
