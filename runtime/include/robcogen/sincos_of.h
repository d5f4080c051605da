// Sines and cosines of many angles at once: one polynomial in the lanes of the processor's vectors.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "robcogen/lanes.h"
#include "robcogen/sincos.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#define ROBCOGEN_RARE static __attribute__((noinline, cold, unused))
#else
#define ROBCOGEN_INLINE static inline
#define ROBCOGEN_RARE static
#endif

// Products and sums that are rounded once: where the processor has them, and the compiler a name for them.
#define ROBCOGEN_FUSES 0
#if defined(__FMA__) && ROBCOGEN_HAS_VECTORS && defined(__has_builtin)
#if __has_builtin(__builtin_elementwise_fma)
#undef ROBCOGEN_FUSES
#define ROBCOGEN_FUSES 1
#define ROBCOGEN_FMA128(a, b, c) __builtin_elementwise_fma(a, b, c)
#define ROBCOGEN_FMA256(a, b, c) __builtin_elementwise_fma(a, b, c)
#define ROBCOGEN_FMA512(a, b, c) __builtin_elementwise_fma(a, b, c)
#elif __has_builtin(__builtin_ia32_vfmaddpd) && __has_builtin(__builtin_ia32_vfmaddpd256)
#undef ROBCOGEN_FUSES
#define ROBCOGEN_FUSES 1
#define ROBCOGEN_FMA128(a, b, c) __builtin_ia32_vfmaddpd(a, b, c)
#define ROBCOGEN_FMA256(a, b, c) __builtin_ia32_vfmaddpd256(a, b, c)
#define ROBCOGEN_FMA512(a, b, c) __builtin_ia32_vfmaddpd512_mask(a, b, c, 0xff, 4)
#endif
#endif

namespace robcogen {
namespace {  // each file's own, as lanes are
namespace lanes {

// The bits of each. `Doubles` is a vector of doubles, or a double.
template <class Doubles>
using Bits = Vector<std::uint64_t, static_cast<int>(sizeof(Doubles) / sizeof(double))>;

template <class Doubles>
ROBCOGEN_INLINE Bits<Doubles> bits(const Doubles& x) noexcept {
  Bits<Doubles> b;
  std::memcpy(&b, &x, sizeof(b));
  return b;
}

template <class Doubles>
ROBCOGEN_INLINE Doubles doubles(const Bits<Doubles>& b) noexcept {
  Doubles x;
  std::memcpy(&x, &b, sizeof(x));
  return x;
}

#if ROBCOGEN_FUSES
// k p + x, rounded once.
ROBCOGEN_INLINE double fused(double k, double p, double x) noexcept {
  return __builtin_fma(k, p, x);
}
ROBCOGEN_INLINE Vector<double, 2> fused(const Vector<double, 2>& k, double p, const Vector<double, 2>& x) noexcept {
  return ROBCOGEN_FMA128(k, (p - Vector<double, 2>{}), x);
}
ROBCOGEN_INLINE Vector<double, 4> fused(const Vector<double, 4>& k, double p, const Vector<double, 4>& x) noexcept {
  return ROBCOGEN_FMA256(k, (p - Vector<double, 4>{}), x);
}
#if defined(__AVX512F__)
ROBCOGEN_INLINE Vector<double, 8> fused(const Vector<double, 8>& k, double p, const Vector<double, 8>& x) noexcept {
  return ROBCOGEN_FMA512(k, (p - Vector<double, 8>{}), x);
}
#endif

// x - k pi / 2 is r - rest, with r its nearest double, or near it. For |k| <= 2^16.
//
// pi / 2 in parts of 53, 33 and 53 bits. The first difference is exact: it is below 1 and a multiple of 2^-53. The
// second is exact where it is below 2^-34, for it is a multiple of 2^-86; where it is larger, r - first and what
// rounding took off r are, for they have less than 53 bits.
template <class Doubles>
ROBCOGEN_INLINE void reduce(const Doubles& x, const Doubles& k, Doubles& r, Doubles& rest) noexcept {
  const Doubles first = fused(k, -0x1.921fb54442d18p+0, x);
  r = fused(k, -0x1.1a62633100000p-54, first);
  rest = fused(k, 0x1.1701b839a2520p-88, fused(k, 0x1.1a62633100000p-54, r - first));
}
#else
// a - t and what rounding added to it (Dekker 1971), where |a| is not smaller than |t| or nothing is added. Exact also
// where the compiler fuses t = k p, which is exact by itself.
template <class Doubles>
ROBCOGEN_INLINE Doubles difference(const Doubles& a, const Doubles& t, Doubles& excess) noexcept {
  const Doubles result = a - t;
  excess = t - (a - result);
  return result;
}

// x - k pi / 2 is r - rest, with r its nearest double, or near it. For |k| <= 2^16.
//
// pi / 2 in parts of 33 bits, of which a multiple below 2^17 is exact (Cody, Waite 1980): where a difference is smaller
// than what it is taken from, it has few enough bits to be exact.
template <class Doubles>
ROBCOGEN_INLINE void reduce(const Doubles& x, const Doubles& k, Doubles& r, Doubles& rest) noexcept {
  Doubles excess1, excess2;
  const Doubles first = x - k * 0x1.921fb54400000p+0;  // exact
  const Doubles second = difference(first, k * 0x1.0b4611a600000p-34, excess1);
  r = difference(second, k * 0x1.3198a2e000000p-69, excess2);
  rest = k * 0x1.b839a252049c1p-104 + (excess1 + excess2);
}
#endif

// Adding it rounds to an integer k, whose last bits then stand in the last bits.
constexpr double kRound = 0x1.8p52 + 0x1p16;

// Of |k| <= 2^16 the bits are below kBeyond, of any other, and of what is no number, not.
constexpr std::uint64_t kBeyond = 1 << 17;
template <class Doubles>
ROBCOGEN_INLINE Bits<Doubles> bits_of_integer(const Doubles& rounded) noexcept {
  constexpr std::uint64_t kNone = 0x4338000000000000;  // of 0x1.8p52
  return bits(rounded) ^ kNone;
}

template <class Doubles>
ROBCOGEN_INLINE Doubles quarter_turns(const Doubles& x) noexcept {
  return x * 0x1.45f306dc9c883p-1 + kRound;
}

// b where the highest bit of `where` is set, else a.
template <class Doubles>
ROBCOGEN_INLINE Doubles chosen(const Bits<Doubles>& where, const Doubles& a, const Doubles& b) noexcept {
#if defined(__AVX__) && ROBCOGEN_HAS_VECTORS
  if constexpr (sizeof(Doubles) == 32) return __builtin_ia32_blendvpd256(a, b, doubles<Doubles>(where));
#endif
  return doubles<Doubles>(bits(a) ^ ((bits(a) ^ bits(b)) & -(where >> 63)));
}

// Minimax polynomials in the angle's square, of relative error 2^-57 and absolute error 2^-59 on [-pi/4, pi/4] (Remez
// exchange, coefficients rounded to double). The result is within 0.8 ulp, and has the sign of a zero.
//
// Of what is beyond their range, |x| of about 1e5, `beyond` gets bits from kBeyond on.
template <class Doubles>
ROBCOGEN_INLINE void polynomials(const Doubles& x, Doubles& sine, Doubles& cosine, Bits<Doubles>& beyond) noexcept {
  const Doubles rounded = quarter_turns(x);
  const Bits<Doubles> k = bits_of_integer(rounded);
  beyond |= k;
  Doubles r, rest;
  reduce<Doubles>(x, rounded - kRound, r, rest);

  const Doubles z = r * r, half = 0.5 * z;
  const Doubles s = 0.16666666666666632 -
                    z * (0.008333333333322413 -
                         z * (0.00019841269829807808 -
                              z * (2.755731369191808e-06 - z * (2.5050758115276912e-08 - z * 1.5896795653837948e-10))));
  const Doubles c =
      0.0416666666666666 +
      z * (-0.0013888888888874125 +
           z * (2.4801587289482194e-05 +
                z * (-2.7557314352335047e-07 + z * (2.087572327348275e-09 + z * -1.1359647814765908e-11))));
  const Doubles one_less = 1.0 - half;
  const Doubles sin_r = r - (z * r * s + one_less * rest);
  const Doubles cos_r = one_less + (((1.0 - one_less) - half + r * rest) + z * z * c);

  // In odd quadrants sine and cosine are exchanged: of the two, each gets what the other has not.
  const Bits<Doubles> odd = k << 63, half_turn = k >> 1 << 63;
  const Bits<Doubles> sine_bits = bits(chosen(odd, sin_r, cos_r)) ^ half_turn;
  sine = doubles<Doubles>(sine_bits);
  cosine = doubles<Doubles>((bits(sin_r) ^ bits(cos_r) ^ odd) ^ sine_bits);
}

// Whether any has a bit from kBeyond on.
template <class Integers>
ROBCOGEN_INLINE bool any_beyond(const Integers& b) noexcept {
#if defined(__AVX__) && ROBCOGEN_HAS_VECTORS
  if constexpr (sizeof(b) == 32) {
    typedef long long Signed __attribute__((vector_size(32)));
    return !__builtin_ia32_ptestz256((Signed)b, (Signed)(b ^ b ^ ~(kBeyond - 1)));
  }
#endif
  std::uint64_t elements[sizeof(b) / sizeof(std::uint64_t)], all = 0;
  std::memcpy(elements, &b, sizeof(b));
  for (const std::uint64_t element : elements) all |= element;
  return all >= kBeyond;
}

// What is out of the range of the polynomials, or no number.
template <class Scalar>
ROBCOGEN_RARE void replace_large(const Scalar* x, int count, Scalar* sine, Scalar* cosine) noexcept {
  for (int i = 0; i < count; ++i) {
    const double angle = x[i];
    if (bits_of_integer(quarter_turns(angle)) < kBeyond) continue;
    sine[i] = static_cast<Scalar>(std::sin(angle));
    cosine[i] = static_cast<Scalar>(std::cos(angle));
  }
}

// By value: what no function has the address of stays in registers.
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
constexpr int kTogether = kInRegister<double> < 4 ? kInRegister<double> : 4;
using Together = Vector<double, kTogether>;

// Lanes beyond the first kUsed are zero.
template <int kUsed, class Scalar, int... kLane>
ROBCOGEN_INLINE Together gathered(const Scalar* x, std::integer_sequence<int, kLane...>) noexcept {
  return Together{(kLane < kUsed ? static_cast<double>(x[kLane < kUsed ? kLane : 0]) : 0.0)...};
}

// From and to the first kUsed elements.
template <int kUsed, class Scalar>
ROBCOGEN_INLINE void sincos_together(const Scalar* x, Scalar* sine, Scalar* cosine, Bits<Together>& beyond) noexcept {
  Together angles, s, c;
  if constexpr (kUsed == kTogether && std::is_same_v<Scalar, double>) {
    // As a block: gcc would move element by element.
    std::memcpy(&angles, x, sizeof(angles));
    polynomials(angles, s, c, beyond);
    std::memcpy(sine, &s, sizeof(s));
    std::memcpy(cosine, &c, sizeof(c));
  } else {
    angles = gathered<kUsed>(x, std::make_integer_sequence<int, kTogether>());
    polynomials(angles, s, c, beyond);
    double sines[kTogether], cosines[kTogether];
    std::memcpy(sines, &s, sizeof(s));
    std::memcpy(cosines, &c, sizeof(c));
    for (int i = 0; i < kUsed; ++i) {
      sine[i] = static_cast<Scalar>(sines[i]);
      cosine[i] = static_cast<Scalar>(cosines[i]);
    }
  }
}

// Scalar: double or float. All angles are computed as double, which for float leaves 0.51 ulp.
template <int kCount, class Scalar>
ROBCOGEN_INLINE void sincos_of(const Scalar* x, Scalar* sine, Scalar* cosine) noexcept {
  constexpr int kWhole = kCount / kTogether * kTogether;
  Bits<Together> beyond = {};
  for (int i = 0; i < kWhole; i += kTogether) sincos_together<kTogether>(x + i, sine + i, cosine + i, beyond);
  // The last ones with some before them once more, where there are as many, for a whole vector moves as a block.
  constexpr int kLast = kCount < kTogether ? kCount : kTogether, kFrom = kCount - kLast;
  if constexpr (kWhole < kCount) sincos_together<kLast>(x + kFrom, sine + kFrom, cosine + kFrom, beyond);
  if (any_beyond(beyond)) replace_large(x, kCount, sine, cosine);
}

// Of lanes: the vectors that they are made of.
template <int kSize>
using LeafOf = Vector<double, (kSize < kInRegister<double> ? kSize : kInRegister<double>)>;

template <int kSize>
ROBCOGEN_INLINE void sincos(
    const Lanes<double, kSize>& x,
    Lanes<double, kSize>& sine,
    Lanes<double, kSize>& cosine,
    Bits<LeafOf<kSize>>& beyond) noexcept {
  if constexpr (kSize <= kInRegister<double>) {
    LeafOf<kSize> s, c;
    polynomials(x.vector(), s, c, beyond);
    sine = Lanes<double, kSize>::of_vector(s);
    cosine = Lanes<double, kSize>::of_vector(c);
  } else {
    Lanes<double, kSize / 2> low_sine, low_cosine, high_sine, high_cosine;
    sincos(x.low(), low_sine, low_cosine, beyond);
    sincos(x.high(), high_sine, high_cosine, beyond);
    sine = {low_sine, high_sine};
    cosine = {low_cosine, high_cosine};
  }
}

template <int kSize>
ROBCOGEN_INLINE void sincos(
    const Lanes<float, kSize>& x,
    Lanes<float, kSize>& sine,
    Lanes<float, kSize>& cosine,
    Bits<LeafOf<kSize>>& beyond) noexcept {
  float numbers[kSize];
  x.store(numbers);
  Lanes<double, kSize> s, c;
  sincos(Lanes<double, kSize>::load(numbers), s, c, beyond);
  s.store(numbers);
  sine = Lanes<float, kSize>::load(numbers);
  c.store(numbers);
  cosine = Lanes<float, kSize>::load(numbers);
}

// Of lanes that fill no more than half of a register, two values at a time; the last one may be alone.
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
  constexpr bool kInPairs = kCount > 1 && 2 * kSize <= kTogether;
  Bits<LeafOf<kInPairs ? 2 * kSize : kSize>> beyond = {};
  if constexpr (kInPairs)
    sincos_in_pairs<kCount>(x, sine, cosine, beyond);
  else
    for (int i = 0; i < kCount; ++i) sincos(x[i], sine[i], cosine[i], beyond);
  if (!any_beyond(beyond)) return;
  for (int i = 0; i < kCount; ++i) {
    const auto both = replaced_large(x[i], sine[i], cosine[i]);
    sine[i] = both.sin;
    cosine[i] = both.cos;
  }
}

// Whether polynomials compute its sines and cosines.
template <class Scalar>
constexpr bool kIsComputed = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;
template <class Scalar, int kSize>
constexpr bool kIsComputed<Lanes<Scalar, kSize>> = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;

}  // namespace lanes
}  // namespace

// As of any other scalar. (Not in the unnamed namespace, where a qualified name would not find it.)
template <class Scalar, int kSize>
ROBCOGEN_INLINE SinCos<Lanes<Scalar, kSize>> sincos(const Lanes<Scalar, kSize>& x) noexcept {
  if constexpr (lanes::kIsComputed<Lanes<Scalar, kSize>>) {
    SinCos<Lanes<Scalar, kSize>> both;
    lanes::Bits<lanes::LeafOf<kSize>> beyond = {};
    lanes::sincos(x, both.sin, both.cos, beyond);
    return lanes::any_beyond(beyond) ? lanes::replaced_large(x, both.sin, both.cos) : both;
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

// A lone sine or cosine costs as much as both.
template <class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, kSize> sin(const Lanes<Scalar, kSize>& x) noexcept {
  return robcogen::sincos(x).sin;
}
template <class Scalar, int kSize>
ROBCOGEN_INLINE Lanes<Scalar, kSize> cos(const Lanes<Scalar, kSize>& x) noexcept {
  return robcogen::sincos(x).cos;
}

// Whether they are computed together: where that is measured to be faster than the C library. Of fewer than four angles
// only those of double that leave few lanes empty; of lanes all.
template <int kCount, class Scalar>
constexpr bool kPays = lanes::kIsComputed<Scalar> && (kCount >= 4 || !std::is_floating_point_v<Scalar>);
template <int kCount>
constexpr bool kPays<kCount, double> = kCount == 2 || kCount >= 4 || (kCount == 3 && lanes::kTogether > 2);

template <int kCount, class Scalar>
ROBCOGEN_INLINE void one_by_one(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  if constexpr (kCount > 0) {
    robcogen::sincos(angles[0], sine[0], cosine[0]);
    one_by_one<kCount - 1>(angles + 1, sine + 1, cosine + 1);
  }
}

// Sines and cosines of kCount angles (rad). For double and float, and lanes of them, within 1 ulp below 1e5 rad, as the
// C library has them beyond, for infinities and for what is no number; the rounding mode must be to nearest. For any
// other scalar its own sin and cos, found by argument-dependent lookup. To be compiled without -ffast-math, as all
// generated code.
template <int kCount, class Scalar>
ROBCOGEN_INLINE void sincos_of(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  if constexpr (kPays<kCount, Scalar>) {
    lanes::sincos_of<kCount>(angles, sine, cosine);
  } else {
    one_by_one<kCount>(angles, sine, cosine);
  }
}

// The same to these places: of angles[i] to the i-th of kTo.
template <int... kTo, class Scalar>
ROBCOGEN_INLINE void sincos_to(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  constexpr int kCount = sizeof...(kTo);
  Scalar sines[kCount], cosines[kCount];
  sincos_of<kCount>(angles, sines, cosines);
  int i = 0;
  ((sine[kTo] = sines[i], cosine[kTo] = cosines[i], ++i), ...);
}

// The same of these angles only, to places of the same numbers.
template <int... kAt, class Scalar>
ROBCOGEN_INLINE void sincos_at(const Scalar* angles, Scalar* sine, Scalar* cosine) noexcept {
  const Scalar packed[] = {angles[kAt]...};
  sincos_to<kAt...>(packed, sine, cosine);
}

// Sines and cosines of kSize angles as a value; of few angles too they are computed together.
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
#undef ROBCOGEN_FUSES
#undef ROBCOGEN_FMA128
#undef ROBCOGEN_FMA256
#undef ROBCOGEN_FMA512
