// Sine and cosine of one angle at once, for any scalar.
#pragma once

#include <cmath>

// Functions whose arguments have no type of the caller are inlined in each file, because files of one program may be
// compiled for different processors.
#if defined(__GNUC__)
#define ROBCOGEN_INLINE inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE inline
#endif

namespace robcogen {

template <class Scalar>
struct SinCos {
  Scalar sin;
  Scalar cos;
};

// For any scalar that has its own sin and cos, which are found by argument-dependent lookup.
template <class Scalar>
inline SinCos<Scalar> sincos(const Scalar& x) {
  using std::cos;
  using std::sin;
  return {sin(x), cos(x)};
}

// The same, written to two places.
template <class Scalar>
inline void sincos(const Scalar& x, Scalar& sine, Scalar& cosine) {
  const SinCos<Scalar> both = sincos(x);
  sine = both.sin;
  cosine = both.cos;
}

// glibc computes both at little more than the cost of one. GCC combines the two calls by itself, clang does not.
ROBCOGEN_INLINE void sincos(const double& x, double& sine, double& cosine) noexcept {
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
  ::sincos(x, &sine, &cosine);
#else
  sine = std::sin(x);
  cosine = std::cos(x);
#endif
}

ROBCOGEN_INLINE void sincos(const float& x, float& sine, float& cosine) noexcept {
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
  ::sincosf(x, &sine, &cosine);
#else
  sine = std::sin(x);
  cosine = std::cos(x);
#endif
}

ROBCOGEN_INLINE SinCos<double> sincos(const double& x) noexcept {
  SinCos<double> both;
  sincos(x, both.sin, both.cos);
  return both;
}

ROBCOGEN_INLINE SinCos<float> sincos(const float& x) noexcept {
  SinCos<float> both;
  sincos(x, both.sin, both.cos);
  return both;
}

}  // namespace robcogen

#undef ROBCOGEN_INLINE
