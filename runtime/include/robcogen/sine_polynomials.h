// Sine and cosine of each element of a vector of doubles: reduction to a quarter turn, and polynomials.
#pragma once

#include <cstdint>
#include <cstring>

#include "robcogen/lanes.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE static inline
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

// Minimax polynomials in z = r^2, of relative error 2^-57 and absolute error 2^-59 for r in [-pi/4, pi/4] (Remez
// exchange, coefficients rounded to double): sin r = r - r z s(z), cos r = 1 - z / 2 + z^2 c(z).
template <class Doubles>
ROBCOGEN_INLINE Doubles rest_of_sine(const Doubles& z) noexcept {
  return 0.16666666666666632 -
         z * (0.008333333333322413 -
              z * (0.00019841269829807808 -
                   z * (2.755731369191808e-06 - z * (2.5050758115276912e-08 - z * 1.5896795653837948e-10))));
}
template <class Doubles>
ROBCOGEN_INLINE Doubles rest_of_cosine(const Doubles& z) noexcept {
  return 0.0416666666666666 +
         z * (-0.0013888888888874125 +
              z * (2.4801587289482194e-05 +
                   z * (-2.7557314352335047e-07 + z * (2.087572327348275e-09 + z * -1.1359647814765908e-11))));
}

#if ROBCOGEN_FUSES
// a b + c, rounded once.
ROBCOGEN_INLINE double fused(double a, double b, double c) noexcept {
  return __builtin_fma(a, b, c);
}
ROBCOGEN_INLINE Vector<double, 2> fused(
    const Vector<double, 2>& a,
    const Vector<double, 2>& b,
    const Vector<double, 2>& c) noexcept {
  return ROBCOGEN_FMA128(a, b, c);
}
ROBCOGEN_INLINE Vector<double, 4> fused(
    const Vector<double, 4>& a,
    const Vector<double, 4>& b,
    const Vector<double, 4>& c) noexcept {
  return ROBCOGEN_FMA256(a, b, c);
}
#if defined(__AVX512F__)
ROBCOGEN_INLINE Vector<double, 8> fused(
    const Vector<double, 8>& a,
    const Vector<double, 8>& b,
    const Vector<double, 8>& c) noexcept {
  return ROBCOGEN_FMA512(a, b, c);
}
#endif

// The same in all elements.
template <class Doubles>
ROBCOGEN_INLINE Doubles all(double x) noexcept {
  return x - Doubles{};
}

// x - k pi / 2 is r - rest, with r its nearest double, or near it. For |k| <= 2^16.
//
// pi / 2 in parts of 53, 33 and 53 bits. The first difference is exact: it is below 1 and a multiple of 2^-53. The
// second is exact where it is below 2^-34, for it is a multiple of 2^-86; where it is larger, r - first and what
// rounding took off r are, for they have less than 53 bits.
template <class Doubles>
ROBCOGEN_INLINE void reduce(const Doubles& x, const Doubles& k, Doubles& r, Doubles& rest) noexcept {
  const Doubles first = fused(k, all<Doubles>(-0x1.921fb54442d18p+0), x);
  r = fused(k, all<Doubles>(-0x1.1a62633100000p-54), first);
  rest = fused(k, all<Doubles>(0x1.1701b839a2520p-88), fused(k, all<Doubles>(0x1.1a62633100000p-54), r - first));
}

// Of r - rest, |r| <= pi / 4, within 0.9 ulp. The cosine gets the rest by way of the square, before that is rounded;
// the sine gets it without the cosine that belongs there, at most 0.15 ulp. The polynomials need not wait for the rest.
template <class Doubles>
ROBCOGEN_INLINE void of_reduced(const Doubles& r, const Doubles& rest, Doubles& sine, Doubles& cosine) noexcept {
  const Doubles z = r * r, square = fused(r, r, -((r + r) * rest));
  sine = r - fused(z * r, rest_of_sine(z), rest);
  cosine = fused(square, fused(square, rest_of_cosine(z), all<Doubles>(-0.5)), all<Doubles>(1.0));
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

// Of r - rest, |r| <= pi / 4, within 0.8 ulp. What rounding takes off 1 - z / 2 is added again.
template <class Doubles>
ROBCOGEN_INLINE void of_reduced(const Doubles& r, const Doubles& rest, Doubles& sine, Doubles& cosine) noexcept {
  const Doubles z = r * r, half = 0.5 * z, one_less = 1.0 - half;
  sine = r - (z * r * rest_of_sine(z) + one_less * rest);
  cosine = one_less + (((1.0 - one_less) - half + r * rest) + z * z * rest_of_cosine(z));
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

// Of what is beyond the range of the polynomials, |x| of about 1e5, `beyond` gets bits from kBeyond on. The last bits
// are those of the integer.
template <class Doubles>
ROBCOGEN_INLINE Bits<Doubles> noted(const Doubles& rounded, Bits<Doubles>& beyond) noexcept {
  const Bits<Doubles> k = bits_of_integer(rounded);
  beyond |= k;
  return k;
}

// Where nothing is.
struct NoneBeyond {};
template <class Doubles>
ROBCOGEN_INLINE Bits<Doubles> noted(const Doubles& rounded, NoneBeyond&) noexcept {
  return bits(rounded);
}

// b where the highest bit of `where` is set, else a.
template <class Doubles>
ROBCOGEN_INLINE Doubles chosen(const Bits<Doubles>& where, const Doubles& a, const Doubles& b) noexcept {
#if defined(__AVX__) && ROBCOGEN_HAS_VECTORS
  if constexpr (sizeof(Doubles) == 32) return __builtin_ia32_blendvpd256(a, b, doubles<Doubles>(where));
#endif
  return doubles<Doubles>(bits(a) ^ ((bits(a) ^ bits(b)) & -(where >> 63)));
}

// The results have the sign of a zero.
template <class Doubles, class Beyond>
ROBCOGEN_INLINE void polynomials(const Doubles& x, Doubles& sine, Doubles& cosine, Beyond& beyond) noexcept {
  const Doubles rounded = quarter_turns(x);
  const Bits<Doubles> k = noted(rounded, beyond);
  Doubles r, rest, sin_r, cos_r;
  reduce<Doubles>(x, rounded - kRound, r, rest);
  of_reduced<Doubles>(r, rest, sin_r, cos_r);

  // In odd quadrants sine and cosine are exchanged: of the two, each gets what the other has not.
  const Bits<Doubles> odd = k << 63, half_turn = k >> 1 << 63;
  const Bits<Doubles> sine_bits = bits(chosen(odd, sin_r, cos_r)) ^ half_turn;
  sine = doubles<Doubles>(sine_bits);
  cosine = doubles<Doubles>((bits(sin_r) ^ bits(cos_r) ^ odd) ^ sine_bits);
}

// The largest root of a sum of squares of angles for which the polynomials hold: for each angle, and for sums of three.
constexpr double kSmall = 3e4;

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

}  // namespace lanes
}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
#undef ROBCOGEN_FUSES
#undef ROBCOGEN_FMA128
#undef ROBCOGEN_FMA256
#undef ROBCOGEN_FMA512
