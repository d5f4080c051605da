// Sine and cosine of one angle at once, for any scalar.
#pragma once

#include <cmath>

namespace robcogen {

template <class Scalar>
struct SinCos {
  Scalar sin;
  Scalar cos;
};

// Any scalar that brings its own sin and cos: they are found by argument-dependent lookup.
template <class Scalar>
inline SinCos<Scalar> sincos(const Scalar& x) {
  using std::cos;
  using std::sin;
  return {sin(x), cos(x)};
}

// glibc computes both for little more than one. GCC finds that out by itself, clang does not.
inline SinCos<double> sincos(const double& x) noexcept {
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
  SinCos<double> result;
  ::sincos(x, &result.sin, &result.cos);
  return result;
#else
  return {std::sin(x), std::cos(x)};
#endif
}

inline SinCos<float> sincos(const float& x) noexcept {
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
  SinCos<float> result;
  ::sincosf(x, &result.sin, &result.cos);
  return result;
#else
  return {std::sin(x), std::cos(x)};
#endif
}

}  // namespace robcogen
