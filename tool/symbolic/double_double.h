// Numbers of about 32 digits, each the unevaluated sum of two doubles (Dekker 1971; Knuth, TAOCP 2, 4.2.2).
//
// Additions, products, quotients and square roots of IEEE doubles are the only operations, in a fixed order and without
// the mathematical library, so that results have the same bits on every machine. Sources that include this are compiled
// without contraction of products and sums (tool/CMakeLists.txt).
#pragma once

#include <cmath>

namespace robcogen::symbolic {

struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;
};

// The sum of two doubles, exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b, share = sum - a;
  return {sum, (a - (sum - share)) + (b - share)};
}

// The same, provided that |a| >= |b| or a is zero.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// The product of two doubles, exactly, unless it overflows (above 1e300).
inline DoubleDouble two_product(double a, double b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const double product = a * b;
  const double scaled_a = kSplit * a, scaled_b = kSplit * b;
  const double a_high = scaled_a - (scaled_a - a), b_high = scaled_b - (scaled_b - b);
  const double a_low = a - a_high, b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
  const DoubleDouble v = quick_two_sum(s.high, s.low + t.high);
  return quick_two_sum(v.high, v.low + t.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + (-b);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble p = two_product(a.high, b.high);
  return quick_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - DoubleDouble{first, 0.0} * b;
  const double second = rest.high / b.high;
  const DoubleDouble left = rest - DoubleDouble{second, 0.0} * b;
  return quick_two_sum(first, second) + DoubleDouble{left.high / b.high, 0.0};
}

inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (a.high == 0.0) return a;
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - two_product(root, root);
  return quick_two_sum(root, rest.high / (2.0 * root));
}

struct SineCosine {
  DoubleDouble sine, cosine;
};

// The sine and cosine of an angle of at most about 1e5 rad, by the Taylor series after reduction to an eighth of a
// turn.
SineCosine sine_cosine(const DoubleDouble& angle);

// The angle with this sine and this cosine.
DoubleDouble atan2(const DoubleDouble& sine, const DoubleDouble& cosine);

// Pi.
inline constexpr DoubleDouble kPiPair{3.141592653589793116e+00, 1.224646799147353207e-16};

}  // namespace robcogen::symbolic
