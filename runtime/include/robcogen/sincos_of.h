// Sines and cosines of many angles at once: one polynomial in the lanes of the processor's vectors.
#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "robcogen/lanes.h"
#include "robcogen/sincos.h"
#include "robcogen/sine_polynomials.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#define ROBCOGEN_RARE static __attribute__((noinline, cold, unused))
#define ROBCOGEN_CALLED static __attribute__((noinline, unused))
#else
#define ROBCOGEN_INLINE static inline
#define ROBCOGEN_RARE static
#define ROBCOGEN_CALLED static
#endif

namespace robcogen {
namespace {  // separate in each file, like lanes
namespace lanes {

// Replaces the results for NaN and for angles out of the range of the polynomials.
template <class Scalar>
ROBCOGEN_RARE void replace_large(const Scalar* x, int count, Scalar* sine, Scalar* cosine) noexcept {
  for (int i = 0; i < count; ++i) {
    if (bits_of_integer(quarter_turns(x[i])) < kBeyond<Scalar>) continue;
    sine[i] = std::sin(x[i]);
    cosine[i] = std::cos(x[i]);
  }
}

// The same with arguments by value: an object whose address is not taken stays in registers.
template <class Scalar, int kSize>
ROBCOGEN_RARE SinCos<Lanes<Scalar, kSize>> replaced_large(
    Lanes<Scalar, kSize> x,
    Lanes<Scalar, kSize> sine,
    Lanes<Scalar, kSize> cosine) noexcept {
  Scalar angles[kSize], sines[kSize], cosines[kSize];
  x.store(angles);
  sine.store(sines);
  cosine.store(cosines);
  replace_large(angles, kSize, sines, cosines);
  return {Lanes<Scalar, kSize>::load(sines), Lanes<Scalar, kSize>::load(cosines)};
}

// Four lanes at most: putting eight angles into one vector costs more than computing two vectors.
template <class Scalar>
constexpr int kTogether = kInRegister<Scalar> < 4 ? kInRegister<Scalar> : 4;
template <class Scalar>
using Together = Vector<Scalar, kTogether<Scalar>>;

// The elements from kFirst on; lanes beyond kCount elements are zero. They are read one by one: numbers that have just
// been computed stay in registers, whereas the load of a vector would wait until all of them are stored.
template <int kFirst, int kCount, class Scalar, int... kLane>
ROBCOGEN_INLINE Together<Scalar> gathered(const Scalar* x, std::integer_sequence<int, kLane...>) noexcept {
  return Together<Scalar>{(kFirst + kLane < kCount ? x[kFirst + kLane < kCount ? kFirst + kLane : 0] : Scalar(0))...};
}

// Stores the first kUsed elements, the first two as a block.
template <int kUsed, class Scalar>
ROBCOGEN_INLINE void store_first(const Together<Scalar>& from, Scalar* to) noexcept {
  if constexpr (kUsed == 1) {
    to[0] = from[0];
  } else {
    std::memcpy(to, &from, 2 * sizeof(Scalar));
    for (int i = 2; i < kUsed; ++i) to[i] = from[i];
  }
}

// Reads and writes the first kUsed elements.
template <int kUsed, class Scalar>
ROBCOGEN_INLINE void sincos_together(
    const Scalar* x,
    Scalar* sine,
    Scalar* cosine,
    Bits<Together<Scalar>>& beyond) noexcept {
  Together<Scalar> angles, s, c;
  if constexpr (kUsed == kTogether<Scalar>) {
    // Copied as a block, because gcc would otherwise move element by element.
    std::memcpy(&angles, x, sizeof(angles));
    polynomials(angles, s, c, beyond);
    std::memcpy(sine, &s, sizeof(s));
    std::memcpy(cosine, &c, sizeof(c));
  } else {
    angles = gathered<0, kUsed>(x, std::make_integer_sequence<int, kTogether<Scalar>>());
    polynomials(angles, s, c, beyond);
    store_first<kUsed>(s, sine);
    store_first<kUsed>(c, cosine);
  }
}

// Scalar: double or float.
template <int kCount, class Scalar>
ROBCOGEN_INLINE void sincos_of(const Scalar* x, Scalar* sine, Scalar* cosine) noexcept {
  constexpr int kSize = kTogether<Scalar>, kWhole = kCount / kSize * kSize;
  Bits<Together<Scalar>> beyond = {};
  for (int i = 0; i < kWhole; i += kSize) sincos_together<kSize>(x + i, sine + i, cosine + i, beyond);
  // If there are enough angles, the last vector overlaps the one before, because a whole vector moves as a block.
  constexpr int kLast = kCount < kSize ? kCount : kSize, kFrom = kCount - kLast;
  if constexpr (kWhole < kCount) sincos_together<kLast>(x + kFrom, sine + kFrom, cosine + kFrom, beyond);
  if (any_beyond<Scalar>(beyond)) replace_large(x, kCount, sine, cosine);
}

// Angles in registers, kTogether in each vector.
template <class Scalar, int kVectors>
struct Angles {
  Together<Scalar> vectors[kVectors];
};

// Replaces the results for NaN and for angles out of the range of the polynomials. The results of the i-th angle are at
// index kTo[i].
template <int... kTo, class Scalar, int kVectors>
ROBCOGEN_RARE void replace_large_at(Angles<Scalar, kVectors> angles, Scalar* sine, Scalar* cosine) noexcept {
  constexpr int kPlaces[] = {kTo...};
  Scalar numbers[kVectors * kTogether<Scalar>];
  std::memcpy(numbers, angles.vectors, sizeof(numbers));
  for (int i = 0; i < static_cast<int>(sizeof...(kTo)); ++i)
    replace_large(numbers + i, 1, sine + kPlaces[i], cosine + kPlaces[i]);
}

// Stores lane i at index kTo[kFirst + i].
template <int kFirst, int... kTo, class Scalar, int... kLane>
ROBCOGEN_INLINE void scatter(const Together<Scalar>& from, Scalar* to, std::integer_sequence<int, kLane...>) noexcept {
  constexpr int kCount = sizeof...(kTo), kPlaces[] = {kTo...};
  constexpr bool kIsBlock =
      ((kFirst + kLane < kCount && kPlaces[kFirst + kLane < kCount ? kFirst + kLane : 0] == kPlaces[kFirst] + kLane) &&
       ...);
  if constexpr (kIsBlock) {
    std::memcpy(to + kPlaces[kFirst], &from, sizeof(from));
  } else {
    ((kFirst + kLane < kCount ? void(to[kPlaces[kFirst + kLane < kCount ? kFirst + kLane : 0]] = from[kLane]) : void()),
     ...);
  }
}

template <int kFirst, int... kTo, class Scalar, int kVectors>
ROBCOGEN_INLINE void sincos_scattered(
    const Scalar* x,
    Scalar* sine,
    Scalar* cosine,
    Angles<Scalar, kVectors>& angles,
    Bits<Together<Scalar>>& beyond) noexcept {
  constexpr auto kLanes = std::make_integer_sequence<int, kTogether<Scalar>>();
  Together<Scalar>& vector = angles.vectors[kFirst / kTogether<Scalar>];
  Together<Scalar> s, c;
  vector = gathered<kFirst, sizeof...(kTo)>(x, kLanes);
  polynomials(vector, s, c, beyond);
  scatter<kFirst, kTo...>(s, sine, kLanes);
  scatter<kFirst, kTo...>(c, cosine, kLanes);
  if constexpr (kFirst + kTogether<Scalar> < static_cast<int>(sizeof...(kTo)))
    sincos_scattered<kFirst + kTogether<Scalar>, kTo...>(x, sine, cosine, angles, beyond);
}

// Stores the sine and cosine of x[i] at index kTo[i]. Scalar: double or float.
template <int... kTo, class Scalar>
ROBCOGEN_INLINE void sincos_to(const Scalar* x, Scalar* sine, Scalar* cosine) noexcept {
  Bits<Together<Scalar>> beyond = {};
  Angles<Scalar, (sizeof...(kTo) + kTogether<Scalar> - 1) / kTogether<Scalar>> angles;
  sincos_scattered<0, kTo...>(x, sine, cosine, angles, beyond);
  if (any_beyond<Scalar>(beyond)) replace_large_at<kTo...>(angles, sine, cosine);
}

// Size of the vectors that values with lanes consist of. SSE registers hold four floats, so two lanes are computed as
// four.
template <class Scalar, int kSize>
constexpr int kLeaf = kSize < kInRegister<Scalar> ? kSize : kInRegister<Scalar>;
#if defined(__SSE2__) && ROBCOGEN_HAS_VECTORS
template <>
constexpr int kLeaf<float, 2> = 4;
#endif
template <class Scalar, int kSize>
using LeafOf = Vector<Scalar, kLeaf<Scalar, kSize>>;

template <class Scalar, int kSize, class Beyond>
ROBCOGEN_INLINE void sincos(
    const Lanes<Scalar, kSize>& x,
    Lanes<Scalar, kSize>& sine,
    Lanes<Scalar, kSize>& cosine,
    Beyond& beyond) noexcept {
  if constexpr (kSize < kLeaf<Scalar, kSize>) {
    Lanes<Scalar, 2 * kSize> s, c;
    sincos(joined(x, x), s, c, beyond);
    sine = half<0>(s);
    cosine = half<0>(c);
  } else if constexpr (kSize <= kInRegister<Scalar>) {
    LeafOf<Scalar, kSize> s, c;
    polynomials(x.vector(), s, c, beyond);
    sine = Lanes<Scalar, kSize>::of_vector(s);
    cosine = Lanes<Scalar, kSize>::of_vector(c);
  } else {
    Lanes<Scalar, kSize / 2> low_sine, low_cosine, high_sine, high_cosine;
    sincos(x.low(), low_sine, low_cosine, beyond);
    sincos(x.high(), high_sine, high_cosine, beyond);
    sine = {low_sine, high_sine};
    cosine = {low_cosine, high_cosine};
  }
}

// For values that fill at most half of a register: computes two at a time; the last one may be single.
template <int kCount, class Scalar, int kSize, class Beyond>
ROBCOGEN_INLINE void sincos_in_pairs(
    const Lanes<Scalar, kSize>* x,
    Lanes<Scalar, kSize>* sine,
    Lanes<Scalar, kSize>* cosine,
    Beyond& beyond) noexcept {
  Lanes<Scalar, 2 * kSize> s, c;
  sincos(joined(x[0], x[kCount > 1 ? 1 : 0]), s, c, beyond);
  sine[0] = half<0>(s);
  cosine[0] = half<0>(c);
  if constexpr (kCount > 1) {
    sine[1] = half<1>(s);
    cosine[1] = half<1>(c);
  }
  if constexpr (kCount > 2) sincos_in_pairs<kCount - 2>(x + 2, sine + 2, cosine + 2, beyond);
}

// Scalar: double or float.
template <int kCount, class Scalar, int kSize>
ROBCOGEN_INLINE void sincos_of(
    const Lanes<Scalar, kSize>* x,
    Lanes<Scalar, kSize>* sine,
    Lanes<Scalar, kSize>* cosine) noexcept {
  constexpr bool kInPairs = kCount > 1 && 2 * kSize <= kTogether<Scalar>;
  Bits<LeafOf<Scalar, kInPairs ? 2 * kSize : kSize>> beyond = {};
  if constexpr (kInPairs)
    sincos_in_pairs<kCount>(x, sine, cosine, beyond);
  else
    for (int i = 0; i < kCount; ++i) sincos(x[i], sine[i], cosine[i], beyond);
  if (!any_beyond<Scalar>(beyond)) return;
  for (int i = 0; i < kCount; ++i) {
    const auto both = replaced_large(x[i], sine[i], cosine[i]);
    sine[i] = both.sin;
    cosine[i] = both.cos;
  }
}

// Whether polynomials compute the sines and cosines of this scalar.
template <class Scalar>
constexpr bool kIsComputed = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;
template <class Scalar, int kSize>
constexpr bool kIsComputed<Lanes<Scalar, kSize>> = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;

}  // namespace lanes
}  // namespace

// For lanes, as for any other scalar. (Not in the unnamed namespace, where a qualified name would not find it.)
template <class Scalar, int kSize>
ROBCOGEN_INLINE SinCos<Lanes<Scalar, kSize>> sincos(const Lanes<Scalar, kSize>& x) noexcept {
  if constexpr (lanes::kIsComputed<Lanes<Scalar, kSize>>) {
    SinCos<Lanes<Scalar, kSize>> both;
    lanes::Bits<lanes::LeafOf<Scalar, kSize>> beyond = {};
    lanes::sincos(x, both.sin, both.cos, beyond);
    return lanes::any_beyond<Scalar>(beyond) ? lanes::replaced_large(x, both.sin, both.cos) : both;
  } else {
    Scalar sines[kSize], cosines[kSize];
    for (int i = 0; i < kSize; ++i) {
      const SinCos<Scalar> both = sincos(x[i]);
      sines[i] = both.sin;
      cosines[i] = both.cos;
    }
    return {Lanes<Scalar, kSize>::load(sines), Lanes<Scalar, kSize>::load(cosines)};
  }
}

namespace {

// Whether all angles are so small that sincos_of_small holds for each of them and for sums of three of them: the sum of
// their squares, in which angles that are in two blocks count twice, is at most 3e4^2 (for float 120^2), and not NaN.
// (Under -ffast-math a NaN may pass: its sine and cosine are NaN either way.)
template <int kCount, class Scalar>
ROBCOGEN_INLINE bool are_small(const Scalar* angles) noexcept {
  constexpr Scalar kLimit = lanes::kSmall<Scalar> * lanes::kSmall<Scalar>;
  constexpr int kSize = kCount < lanes::kInRegister<Scalar> ? 1 : lanes::kInRegister<Scalar>;
  using Block = Lanes<Scalar, kSize>;
  Block sum = Block::load(angles) * Block::load(angles);
  for (int i = kSize; i < kCount; i += kSize) {
    const Block x = Block::load(angles + (i + kSize <= kCount ? i : kCount - kSize));
    sum = sum + x * x;
  }
#if defined(__AVX__) && ROBCOGEN_HAS_VECTORS
  if constexpr (std::is_same_v<Scalar, double> && kSize == 4) {
    constexpr int kNotLessOrEqual = 0x16;
    const auto large = __builtin_ia32_cmppd256(sum.vector(), Block(kLimit).vector(), kNotLessOrEqual);
    return __builtin_ia32_vtestzpd256(large, large);
  }
#endif
  return sum_lanes(sum) <= kLimit;
}

// Sines and cosines of angles that pass this test.
template <class Scalar, int kSize>
ROBCOGEN_INLINE SinCos<Lanes<Scalar, kSize>> sincos_of_small(const Lanes<Scalar, kSize>& x) noexcept {
  if constexpr (lanes::kIsComputed<Scalar>) {
    SinCos<Lanes<Scalar, kSize>> both;
    lanes::NoneBeyond none;
    lanes::sincos(x, both.sin, both.cos, none);
    return both;
  } else {
    return robcogen::sincos(x);
  }
}

// A single sine or cosine costs as much as both.
template <class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, kSize> sin(const Lanes<Scalar, kSize>& x) noexcept {
  return robcogen::sincos(x).sin;
}
template <class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, kSize> cos(const Lanes<Scalar, kSize>& x) noexcept {
  return robcogen::sincos(x).cos;
}

// Whether angles are computed together, where measurements show that this is faster than the C library: two and three
// angles only for double, lanes always.
template <int kCount, class Scalar>
constexpr bool kPays = lanes::kIsComputed<Scalar> && (kCount >= 4 || !std::is_floating_point_v<Scalar>);
template <int kCount>
constexpr bool kPays<kCount, double> = kCount >= 2;

template <int kCount, class Scalar>
ROBCOGEN_INLINE void one_by_one(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  if constexpr (kCount > 0) {
    robcogen::sincos(angles[0], sine[0], cosine[0]);
    one_by_one<kCount - 1>(angles + 1, sine + 1, cosine + 1);
  }
}

// Sines and cosines of kCount angles (rad), computed in the scalar's own precision, also in lanes: for double within
// 1 ulp below 1e5 rad, for float within 1.5 ulp below 400 rad. Beyond, for infinities and for NaN, those of the C
// library. The rounding mode must be to nearest. Under -ffast-math the errors are up to twice these, or 1e-20 where
// that is more. For any other scalar its own sin and cos, found by argument-dependent lookup.
template <int kCount, class Scalar>
ROBCOGEN_INLINE void sincos_of(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  if constexpr (kPays<kCount, Scalar>) {
    lanes::sincos_of<kCount>(angles, sine, cosine);
  } else {
    one_by_one<kCount>(angles, sine, cosine);
  }
}

// The same, with the sine and cosine of angles[i] stored at index kTo[i].
template <int... kTo, class Scalar>
ROBCOGEN_INLINE void sincos_to(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  constexpr int kCount = sizeof...(kTo);
  if constexpr (kPays<kCount, Scalar> && std::is_floating_point_v<Scalar>) {
    lanes::sincos_to<kTo...>(angles, sine, cosine);
  } else {
    Scalar sines[kCount], cosines[kCount];
    sincos_of<kCount>(angles, sines, cosines);
    int i = 0;
    ((sine[kTo] = sines[i], cosine[kTo] = cosines[i], ++i), ...);
  }
}

// The same for the angles with indices kAt only; the results have the same indices.
template <int... kAt, class Scalar>
ROBCOGEN_INLINE void sincos_at(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  const Scalar packed[] = {angles[kAt]...};
  sincos_to<kAt...>(packed, sine, cosine);
}

// The same as functions that are compiled once in a file and called: for kernels of which there are many.
namespace called {

template <int kCount, class Scalar>
ROBCOGEN_CALLED void sincos_of(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  robcogen::sincos_of<kCount>(angles, sine, cosine);
}

template <int... kTo, class Scalar>
ROBCOGEN_CALLED void sincos_to(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  robcogen::sincos_to<kTo...>(angles, sine, cosine);
}

template <int... kAt, class Scalar>
ROBCOGEN_CALLED void sincos_at(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  robcogen::sincos_at<kAt...>(angles, sine, cosine);
}

}  // namespace called

// Sines and cosines of kSize angles as a value. They are computed together even for few angles.
template <class Scalar, int kSize>
class SinCosOf {
 public:
  explicit SinCosOf(const Scalar* angles) noexcept {
    if constexpr (lanes::kIsComputed<Scalar>) {
      lanes::sincos_of<kSize>(angles, sin_, cos_);
    } else {
      one_by_one<kSize>(angles, sin_, cos_);
    }
  }

  SinCos<Scalar> operator[](int i) const noexcept { return {sin_[i], cos_[i]}; }

 private:
  Scalar sin_[kSize];
  Scalar cos_[kSize];
};

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
#undef ROBCOGEN_RARE
#undef ROBCOGEN_CALLED
