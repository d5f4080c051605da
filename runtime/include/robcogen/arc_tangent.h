// Angles from their sines and cosines, without branches: one polynomial for a number or for the lanes of a vector.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "robcogen/lanes.h"
#include "robcogen/magnitude.h"
#include "robcogen/sine_polynomials.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE static inline
#endif

namespace robcogen {
namespace {  // separate in each file, like lanes
namespace lanes {

// Minimax polynomials in z = t^2 for t in [-1/2, 1/2] (Remez exchange, coefficients rounded one after the other):
// atan t = t + t z a(z). The relative error of atan t is 2^-57.6 for double and 2^-27 for float. Even and odd powers
// are summed apart, which halves the latency.
template <class Numbers>
ROBCOGEN_INLINE Numbers rest_of_arc_tangent(const Numbers& z) noexcept {
  const Numbers y = z * z;
  if constexpr (kIsSingle<Numbers>) {
    const Numbers even = -0x1.555512p-2f + y * (-0x1.224956p-3f + y * -0x1.a3c238p-5f);
    const Numbers odd = 0x1.997b02p-3f + y * 0x1.9ff658p-4f;
    return even + z * odd;
  } else {
    const Numbers even = -0.3333333333333298 +
                         y * (-0.1428571427638877 +
                              y * (-0.09090896248319676 +
                                   y * (-0.0666381115682923 + y * (-0.05122020451726037 + y * -0.027435540104686972))));
    const Numbers odd = 0.1999999999990313 +
                        y * (0.11111110659776789 +
                             y * (0.07692073967524499 +
                                  y * (0.05858302395471654 + y * (0.04186543224241787 + y * 0.010117238483047363))));
    return even + z * odd;
  }
}

// x where the highest bit of `where` is set, otherwise 0.
template <class Numbers>
ROBCOGEN_INLINE Numbers where_set(const Bits<Numbers>& where, Element<Numbers> x) noexcept {
  return chosen<Numbers>(where, Numbers{}, x - Numbers{});
}

// The angle from -pi to pi whose tangent is y / x, in the quadrant of (x, y).
//
// The ratio of the smaller to the larger magnitude is turned by -pi / 4 where it exceeds 1/2; the difference is exact
// then. The angle is k pi / 4 plus or minus the arc tangent of the result.
template <class Numbers>
ROBCOGEN_INLINE Numbers arc_tangent_of(const Numbers& y, const Numbers& x) noexcept {
  using Scalar = Element<Numbers>;
  constexpr int kHighest = 8 * static_cast<int>(sizeof(Scalar)) - 1;
  // The first part has so few bits that its multiples are exact.
  constexpr auto kPart1 = constant<Scalar>(0x1.921fbp-1f, 0x1.921fb54442d1p-1);
  constexpr auto kPart2 = constant<Scalar>(0x1.5110b4p-23f, 0x1.08d313198a2ep-50);
  const Numbers up = without_sign(y), along = without_sign(x);
  const Bits<Numbers> steep = bits<Numbers>(along - up);
  const Numbers less = chosen<Numbers>(steep, up, along), more = chosen<Numbers>(steep, along, up);
  const Bits<Numbers> turned = bits<Numbers>(more - (less + less));
  // Both are zero for (0, 0), whose angle is 0 or pi, as in the C library.
  const Numbers ratio = chosen<Numbers>(turned, less, less - more) /
                        (chosen<Numbers>(turned, more, less + more) + std::numeric_limits<Scalar>::min());
  const Numbers z = ratio * ratio, angle = ratio + ratio * z * rest_of_arc_tangent(z);
  const Numbers of_less = where_set<Numbers>(turned, 1),
                of_quadrant = without_sign(where_set<Numbers>(steep, 2) - of_less);
  const Numbers k = without_sign(where_set<Numbers>(bits(x), 4) - of_quadrant);
  const Bits<Numbers> backward = (steep ^ bits(x)) >> kHighest << kHighest, below = bits(y) >> kHighest << kHighest;
  const Numbers upper = k * kPart1 + (numbers<Numbers>(bits(angle) ^ backward) + k * kPart2);
  return numbers<Numbers>(bits(upper) ^ below);
}

}  // namespace lanes

// The angle (rad, from -pi to pi) whose sine and cosine these are, or equal multiples of them: within 2 ulp for double
// and float, also in lanes. Not for infinities, nor where the sum of both overflows or is not a normal number. For any
// other scalar its own atan2, found by argument-dependent lookup.
ROBCOGEN_INLINE double arc_tangent(double sine, double cosine) noexcept {
  return lanes::arc_tangent_of(sine, cosine);
}
ROBCOGEN_INLINE float arc_tangent(float sine, float cosine) noexcept {
  return lanes::arc_tangent_of(sine, cosine);
}
template <class Sine, class Cosine>
ROBCOGEN_INLINE auto arc_tangent(const Sine& sine, const Cosine& cosine) noexcept {
  using std::atan2;
  return atan2(sine, cosine);
}

template <class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, kSize> atan2(
    const Lanes<Scalar, kSize>& sine,
    const Lanes<Scalar, kSize>& cosine) noexcept {
  if constexpr (kSize > 1 && kSize > lanes::kInRegister<Scalar>)
    return {atan2(sine.low(), cosine.low()), atan2(sine.high(), cosine.high())};
  else if constexpr (std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>)
    return Lanes<Scalar, kSize>::of_vector(lanes::arc_tangent_of(sine.vector(), cosine.vector()));
  else
    return Lanes<Scalar, kSize>::of_vector(arc_tangent(sine.vector(), cosine.vector()));
}

// The angles of kCount sines and cosines, which are stored one after the other.
template <int kCount, class Scalar>
ROBCOGEN_INLINE void arc_tangents_of(const Scalar* sine, const Scalar* cosine, Scalar* angle) noexcept {
  constexpr int kSize = kCount < lanes::kInRegister<Scalar> ? 1 : lanes::kInRegister<Scalar>;
  using Block = Lanes<Scalar, kSize>;
  for (int i = 0; i < kCount; i += kSize) {
    const int from = i + kSize <= kCount ? i : kCount - kSize;  // the last block overlaps the one before
    if constexpr (kSize == 1)
      angle[i] = arc_tangent(sine[i], cosine[i]);
    else
      atan2(Block::load(sine + from), Block::load(cosine + from)).store(angle + from);
  }
}

namespace lanes {

// The angles of neighbouring pairs of a sine and a cosine, from kFirst on.
template <int kFirst, class Scalar, int... kLane>
ROBCOGEN_INLINE void arc_tangents_to(
    Scalar* angles,
    const Scalar* const* pairs,
    std::integer_sequence<int, kLane...>) noexcept {
  using Block = Lanes<Scalar, sizeof...(kLane)>;
  atan2(Block::of(*pairs[2 * (kFirst + kLane)]...), Block::of(*pairs[2 * (kFirst + kLane) + 1]...))
      .store(angles + kFirst);
}

// In lanes: first as many that blocks of four remain, because the first angles of a chain are known first.
template <int kFirst, int kCount, class Scalar>
ROBCOGEN_INLINE void arc_tangents_from(Scalar* angles, const Scalar* const* pairs) noexcept {
  constexpr int kSize = (kCount - kFirst) % 2 == 1 ? 1 : (kCount - kFirst) % 4 == 2 ? 2 : 4;
  arc_tangents_to<kFirst>(angles, pairs, std::make_integer_sequence<int, kSize>());
  if constexpr (kFirst + kSize < kCount) arc_tangents_from<kFirst + kSize, kCount>(angles, pairs);
}

}  // namespace lanes

// The angles of pairs of a sine and a cosine, in this order, stored one after the other.
template <class Scalar, class... Number>
ROBCOGEN_INLINE void arc_tangents_to(Scalar* angles, const Number&... of_pairs) noexcept {
  constexpr int kCount = sizeof...(Number) / 2;
  if constexpr (std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>) {
    const Scalar* const pairs[] = {&of_pairs...};
    lanes::arc_tangents_from<0, kCount>(angles, pairs);
  } else {
    const Scalar pairs[] = {Scalar(of_pairs)...};
    for (int i = 0; i < kCount; ++i) angles[i] = arc_tangent(pairs[2 * i], pairs[2 * i + 1]);
  }
}

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
