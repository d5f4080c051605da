// A dual number for the tests: a value and a derivative.
//
// There are no implicit conversions, and only the operations that a scalar must have: a kernel that needs more does not
// compile.
#pragma once

#include <cmath>

namespace autodiff {

struct Dual {
  double value = 0;
  double derivative = 0;

  Dual() = default;
  explicit Dual(double v, double d = 0) : value(v), derivative(d) {}
};

inline Dual operator-(const Dual& a) {
  return Dual(-a.value, -a.derivative);
}
inline Dual operator+(const Dual& a, const Dual& b) {
  return Dual(a.value + b.value, a.derivative + b.derivative);
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return Dual(a.value - b.value, a.derivative - b.derivative);
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return Dual(a.value * b.value, a.derivative * b.value + a.value * b.derivative);
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return Dual(quotient, (a.derivative - quotient * b.derivative) / b.value);
}
inline Dual sin(const Dual& a) {
  return Dual(std::sin(a.value), std::cos(a.value) * a.derivative);
}
inline Dual cos(const Dual& a) {
  return Dual(std::cos(a.value), -std::sin(a.value) * a.derivative);
}
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return Dual(root, a.derivative / (2 * root));
}

}  // namespace autodiff
