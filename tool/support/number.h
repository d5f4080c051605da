// A real constant that remembers when it is exactly rational, or exactly a rational multiple of PI.
//
// Documents contain `PI/2.0` and `0.1`. Folding in doubles is inexact: cos(PI/2) becomes 6e-17, and a transform that is
// a signed permutation becomes 9 products. A Number is folded exactly as long as possible, and otherwise is the nearest
// double.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace robcogen {

// num / den in lowest terms, den > 0.
struct Rational {
  std::int64_t num = 0;
  std::int64_t den = 1;
  friend bool operator==(const Rational&, const Rational&) = default;
};

class Number {
 public:
  Number() = default;  // exactly zero
  explicit Number(double value);
  static Number rational(std::int64_t num, std::int64_t den = 1);
  static Number pi_multiple(std::int64_t num, std::int64_t den = 1);
  // The nearest double of a decimal literal (`1`, `.5`, `-1.0E5`). It is exactly rational if the shortest decimal
  // fraction of that double fits 64-bit num / den, so that two literals of one double are one Number. nullopt if the
  // text is not a number, or is beyond the largest double. A literal below the smallest double is zero.
  static std::optional<Number> parse(const std::string& literal);

  double value() const { return value_; }
  bool is_zero() const { return value_ == 0.0; }
  bool is_pi_multiple() const { return ratio_.has_value() && times_pi_; }
  // The factor r of an exact `r` or `r * PI`; nullopt if only the double is known.
  const std::optional<Rational>& ratio() const { return ratio_; }

  friend Number operator-(const Number& a);
  friend Number operator+(const Number& a, const Number& b);
  friend Number operator-(const Number& a, const Number& b);
  friend Number operator*(const Number& a, const Number& b);
  friend Number operator/(const Number& a, const Number& b);
  // Exact multiples of PI are reduced correctly: sin(PI) is 0, cos(PI/3) is 1/2, sin(PI/4) == cos(PI/4).
  friend Number sin(const Number& a);
  friend Number cos(const Number& a);
  friend Number tan(const Number& a);
  friend Number sqrt(const Number& a);

  // Whether both the doubles and the exact forms are the same.
  friend bool operator==(const Number& a, const Number& b);

 private:
  // `ratio` must be in lowest terms.
  static Number exact(const Rational& ratio, bool times_pi);

  double value_ = 0.0;
  std::optional<Rational> ratio_ = Rational{0, 1};
  bool times_pi_ = false;
};

// The number as a document spells it: `0.25`, `1.0/3.0`, `PI/2.0`, `-2.0 PI/3.0`. The text reads back as the same
// double and, if the number is exact and its parts are integers that literals can hold, as the same exact form.
std::string print(const Number& n);

// The shortest text that reads back as exactly this double, always with a '.' or an exponent: `1.0`, `0.35`, `1e-09`.
// It does not depend on the locale.
std::string print_double(double value);
std::string print_float(float value);

}  // namespace robcogen
