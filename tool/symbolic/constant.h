// A constant of a program, and of the graph that the program is traced in.
//
// Constants that stand for a set, as a mass of four legs that differ by a gram, can fold as a representative of the set
// does: the constant is zero, one, or equal to another constant only when its own number and the representative one
// are. Sums, products and quotients compute both.
#pragma once

#include <optional>

#include "support/number.h"

namespace robcogen::symbolic {

class Constant {
 public:
  Constant() = default;  // exactly zero
  Constant(const Number& number) : number_(number) {}

  // The same number, with the representative one of its set.
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
