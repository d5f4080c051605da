// Numbers in a few states at once, as double, float or with 32 digits, and the states: they are the same for all
// programs of a function, and on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "support/index.h"
#include "symbolic/double_double.h"
#include "symbolic/program.h"

namespace robcogen::symbolic {

inline constexpr std::size_t kStates = 16;

// A value in all states.
template <class Real>
struct Batch {
  std::array<Real, kStates> value;
};
template <>
struct Batch<DoubleDouble> {
  std::array<double, kStates> high, low;
};

template <class Real>
Real get(const Batch<Real>& batch, std::size_t state) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return {batch.high[state], batch.low[state]};
  else
    return batch.value[state];
}

template <class Real>
void set(Batch<Real>& batch, std::size_t state, const Real& value) {
  if constexpr (std::is_same_v<Real, DoubleDouble>) {
    batch.high[state] = value.high;
    batch.low[state] = value.low;
  } else {
    batch.value[state] = value;
  }
}

template <class Real>
Real rounded(const DoubleDouble& x) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return x;
  else
    return static_cast<Real>(x.high);
}

// An integer with all its digits.
DoubleDouble exact(std::int64_t n);

// The value of a literal. As in the generated code it is rounded to double, also in the reference; multiples of PI are
// exact there.
template <class Real>
Real literal_as(const Number& n) {
  if constexpr (std::is_same_v<Real, DoubleDouble>) {
    if (!n.is_pi_multiple()) return {n.value(), 0.0};
    return kPiPair * (exact(n.ratio()->num) / exact(n.ratio()->den));
  } else {
    return static_cast<Real>(n.value());
  }
}

// The values of all input elements in all states. `parameters`: the values of the input with the role `parameters`;
// missing ones are near one.
std::vector<Batch<double>> inputs_of(const Program& program, const std::vector<double>& parameters);

// ---- Operations in all states.

// `f`: of the number of a state.
template <class Real, class F>
Batch<Real> in_all_states(F f) {
  Batch<Real> result;
  for (std::size_t s = 0; s < kStates; ++s) set(result, s, Real(f(s)));
  return result;
}
template <class Real, class F>
Batch<Real> in_all_states(const Batch<Real>& a, F f) {
  return in_all_states<Real>([&](std::size_t s) { return f(get(a, s)); });
}
template <class Real, class F>
Batch<Real> in_all_states(const Batch<Real>& a, const Batch<Real>& b, F f) {
  return in_all_states<Real>([&](std::size_t s) { return f(get(a, s), get(b, s)); });
}

template <class Real>
Batch<Real> operator-(const Batch<Real>& a) {
  return in_all_states(a, [](const Real& x) { return -x; });
}
template <class Real>
Batch<Real> operator+(const Batch<Real>& a, const Batch<Real>& b) {
  return in_all_states(a, b, [](const Real& x, const Real& y) { return x + y; });
}
template <class Real>
Batch<Real> operator-(const Batch<Real>& a, const Batch<Real>& b) {
  return in_all_states(a, b, [](const Real& x, const Real& y) { return x - y; });
}
template <class Real>
Batch<Real> operator*(const Batch<Real>& a, const Batch<Real>& b) {
  return in_all_states(a, b, [](const Real& x, const Real& y) { return x * y; });
}
template <class Real>
Batch<Real> operator/(const Batch<Real>& a, const Batch<Real>& b) {
  return in_all_states(a, b, [](const Real& x, const Real& y) { return x / y; });
}
template <class Real>
Batch<Real> atan2(const Batch<Real>& a, const Batch<Real>& b) {
  using std::atan2;
  return in_all_states(a, b, [](const Real& x, const Real& y) { return atan2(x, y); });
}
template <class Real>
Batch<Real> sqrt(const Batch<Real>& a) {
  using std::sqrt;
  return in_all_states(a, [](const Real& x) { return sqrt(x); });
}

// Sines and cosines are those with 32 digits, rounded: those of the mathematical library differ between machines.
template <class Real>
SineCosine sine_cosine_of(const Real& angle) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return sine_cosine(angle);
  else
    return sine_cosine({static_cast<double>(angle), 0.0});
}
template <class Real>
Batch<Real> sin(const Batch<Real>& a) {
  return in_all_states(a, [](const Real& x) { return rounded<Real>(sine_cosine_of(x).sine); });
}
template <class Real>
Batch<Real> cos(const Batch<Real>& a) {
  return in_all_states(a, [](const Real& x) { return rounded<Real>(sine_cosine_of(x).cosine); });
}

}  // namespace robcogen::symbolic
