// Magnitudes of numbers and of lanes.
#pragma once

#include <cmath>
#include <type_traits>

#include "robcogen/lanes.h"
#include "robcogen/sine_polynomials.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE static inline
#endif

namespace robcogen {
namespace {  // separate in each file, like lanes
namespace lanes {

template <class Numbers>
ROBCOGEN_INLINE Numbers without_sign(const Numbers& x) noexcept {
  using Bit = BitsOfOne<Element<Numbers>>;
  return numbers<Numbers>(bits(x) & static_cast<Bit>(static_cast<Bit>(-1) >> 1));
}

}  // namespace lanes

// x without its sign, also in lanes. For a scalar other than double and float its own abs, found by argument-dependent
// lookup.
template <class Scalar>
ROBCOGEN_INLINE Scalar magnitude(const Scalar& x) noexcept {
  using std::abs;
  if constexpr (std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>)
    return lanes::without_sign(x);
  else
    return abs(x);
}

template <class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, kSize> magnitude(const Lanes<Scalar, kSize>& x) noexcept {
  if constexpr (kSize > 1 && kSize > lanes::kInRegister<Scalar>)
    return {magnitude(x.low()), magnitude(x.high())};
  else if constexpr (std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>)
    return Lanes<Scalar, kSize>::of_vector(lanes::without_sign(x.vector()));
  else
    return Lanes<Scalar, kSize>::of_vector(magnitude(x.vector()));
}

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
