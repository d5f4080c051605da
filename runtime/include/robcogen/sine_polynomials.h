// Sine and cosine of each element of a vector of doubles or floats: reduction to a quarter turn, and polynomials.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "robcogen/as_rounded.h"
#include "robcogen/lanes.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE static inline
#endif

// Fused products and sums, rounded once, are used if the processor has them and the compiler has an intrinsic.
#define ROBCOGEN_FUSES 0
#if defined(__FMA__) && ROBCOGEN_HAS_VECTORS && defined(__has_builtin)
#if __has_builtin(__builtin_elementwise_fma)
#undef ROBCOGEN_FUSES
#define ROBCOGEN_FUSES 1
#define ROBCOGEN_FMA(suffix, a, b, c) __builtin_elementwise_fma(a, b, c)
#define ROBCOGEN_FMA512(suffix, a, b, c) __builtin_elementwise_fma(a, b, c)
#elif __has_builtin(__builtin_ia32_vfmaddpd) && __has_builtin(__builtin_ia32_vfmaddpd256)
#undef ROBCOGEN_FUSES
#define ROBCOGEN_FUSES 1
#define ROBCOGEN_FMA(suffix, a, b, c) __builtin_ia32_vfmadd##suffix(a, b, c)
#define ROBCOGEN_FMA512(suffix, a, b, c) __builtin_ia32_vfmadd##suffix##512_mask(a, b, c, ROBCOGEN_ALL_##suffix, 4)
// The masks of all lanes, of the types that the compilers declare: gcc's mask of sixteen has a sign.
#define ROBCOGEN_ALL_pd 0xff
#if defined(__clang__)
#define ROBCOGEN_ALL_ps 0xffff
#else
#define ROBCOGEN_ALL_ps -1
#endif
#endif
#endif

namespace robcogen {
namespace {  // separate in each file, like lanes
namespace lanes {

// `Numbers` is a vector of doubles or of floats, or a single number.
template <class Numbers, bool kIsOne = std::is_floating_point_v<Numbers>>
struct ElementOf {
  using type = std::remove_cv_t<std::remove_reference_t<decltype(std::declval<const Numbers&>()[0])>>;
};
template <class Numbers>
struct ElementOf<Numbers, true> {
  using type = Numbers;
};
template <class Numbers>
using Element = typename ElementOf<Numbers>::type;
template <class Numbers>
constexpr bool kIsSingle = std::is_same_v<Element<Numbers>, float>;

// A constant in each precision.
template <class Scalar>
constexpr Scalar constant(float of_float, double of_double) noexcept {
  if constexpr (std::is_same_v<Scalar, float>)
    return of_float;
  else
    return of_double;
}

// The bits of each element.
template <class Scalar>
using BitsOfOne = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
template <class Numbers>
using Bits = Vector<BitsOfOne<Element<Numbers>>, static_cast<int>(sizeof(Numbers) / sizeof(Element<Numbers>))>;

template <class Numbers>
ROBCOGEN_INLINE Bits<Numbers> bits(const Numbers& x) noexcept {
  Bits<Numbers> b;
  std::memcpy(&b, &x, sizeof(b));
  return b;
}

template <class Numbers>
ROBCOGEN_INLINE Numbers numbers(const Bits<Numbers>& b) noexcept {
  Numbers x;
  std::memcpy(&x, &b, sizeof(x));
  return x;
}

// Minimax polynomials in z = r^2 for r in [-pi/4, pi/4] (Remez exchange, coefficients rounded): sin r = r - r z s(z),
// cos r = 1 - z / 2 + z^2 c(z). For double the relative error of the sine is 2^-57 and the error of the cosine 2^-59,
// for float 2^-27 and 2^-31.
template <class Numbers>
ROBCOGEN_INLINE Numbers rest_of_sine(const Numbers& z) noexcept {
  if constexpr (kIsSingle<Numbers>)
    return 0x1.555546p-3f - z * (0x1.11074p-7f - z * 0x1.994374p-13f);
  else
    return 0.16666666666666632 -
           z * (0.008333333333322413 -
                z * (0.00019841269829807808 -
                     z * (2.755731369191808e-06 - z * (2.5050758115276912e-08 - z * 1.5896795653837948e-10))));
}
template <class Numbers>
ROBCOGEN_INLINE Numbers rest_of_cosine(const Numbers& z) noexcept {
  if constexpr (kIsSingle<Numbers>)
    return 0x1.55554ap-5f + z * (-0x1.6c0c84p-10f + z * 0x1.9a01f8p-16f);
  else
    return 0.0416666666666666 +
           z * (-0.0013888888888874125 +
                z * (2.4801587289482194e-05 +
                     z * (-2.7557314352335047e-07 + z * (2.087572327348275e-09 + z * -1.1359647814765908e-11))));
}

#if ROBCOGEN_FUSES
// a b + c, rounded once.
template <class Numbers>
ROBCOGEN_INLINE Numbers fused(const Numbers& a, const Numbers& b, const Numbers& c) noexcept {
  if constexpr (std::is_same_v<Numbers, double>) {
    return __builtin_fma(a, b, c);
  } else if constexpr (std::is_same_v<Numbers, float>) {
    return __builtin_fmaf(a, b, c);
  } else if constexpr (kIsSingle<Numbers>) {
    if constexpr (sizeof(Numbers) == 16) return ROBCOGEN_FMA(ps, a, b, c);
    if constexpr (sizeof(Numbers) == 32) return ROBCOGEN_FMA(ps256, a, b, c);
#if defined(__AVX512F__)
    if constexpr (sizeof(Numbers) == 64) return ROBCOGEN_FMA512(ps, a, b, c);
#endif
  } else {
    if constexpr (sizeof(Numbers) == 16) return ROBCOGEN_FMA(pd, a, b, c);
    if constexpr (sizeof(Numbers) == 32) return ROBCOGEN_FMA(pd256, a, b, c);
#if defined(__AVX512F__)
    if constexpr (sizeof(Numbers) == 64) return ROBCOGEN_FMA512(pd, a, b, c);
#endif
  }
}

// The same number in all elements.
template <class Numbers>
ROBCOGEN_INLINE Numbers all(Element<Numbers> x) noexcept {
  return x - Numbers{};
}

// Computes x - k pi / 2 as r - rest, where r is the nearest number to it, or near that. For |k| <= 2^16.
//
// For double, pi / 2 has parts of 53, 33 and 53 bits. The first difference is exact: it is below 1 and a multiple of
// 2^-53. The second is exact when it is below 2^-34, because it is a multiple of 2^-86; when it is larger, r - first
// and the rounding error of r are exact, because they have less than 53 bits. For float the parts have 24, 16 and 24
// bits: multiples of 2^-24 and 2^-40, exact below 2^-16.
template <class Numbers>
ROBCOGEN_INLINE void reduce(const Numbers& x, const Numbers& k, Numbers& r, Numbers& rest) noexcept {
  using Scalar = Element<Numbers>;
  constexpr auto kPart1 = constant<Scalar>(0x1.921fb6p+0f, 0x1.921fb54442d18p+0);
  constexpr auto kPart2 = constant<Scalar>(-0x1.777ap-25f, 0x1.1a62633100000p-54);
  constexpr auto kPart3 = constant<Scalar>(-0x1.73dcb4p-43f, 0x1.1701b839a2520p-88);
  const Numbers first = fused(k, all<Numbers>(-kPart1), x);
  r = fused(k, all<Numbers>(-kPart2), first);
  rest = fused(k, all<Numbers>(kPart3), fused(k, all<Numbers>(kPart2), r - first));
}

// Sine and cosine of r - rest, |r| <= pi / 4, within 0.9 ulp. The rest enters the cosine through the square, before
// rounding; it enters the sine without its factor, the cosine, which is an error of at most 0.15 ulp. The polynomials
// do not wait for the rest.
template <class Numbers>
ROBCOGEN_INLINE void of_reduced(const Numbers& r, const Numbers& rest, Numbers& sine, Numbers& cosine) noexcept {
  const Numbers z = r * r, square = fused(r, r, -((r + r) * rest));
  sine = r - fused(z * r, rest_of_sine(z), rest);
  cosine = fused(
      square, fused(square, rest_of_cosine(z), all<Numbers>(Element<Numbers>(-0.5))),
      all<Numbers>(Element<Numbers>(1.0)));
}
#else
// a - t and its rounding error (Dekker 1971), if |a| >= |t| or the error is zero. Exact also if the compiler fuses
// t = k p, which is exact.
template <class Numbers>
ROBCOGEN_INLINE Numbers difference(const Numbers& a, const Numbers& t, Numbers& excess) noexcept {
  const Numbers result = as_rounded(a - t);
  excess = t - as_rounded(a - result);
  return result;
}

// Computes x - k pi / 2 as r - rest, where r is the nearest number to it, or near that. For |k| <= 2^16, for float 2^8.
//
// For double, pi / 2 has parts of 33 bits, whose multiples below 2^17 are exact (Cody, Waite 1980): when a difference
// is smaller than its minuend, it has few enough bits to be exact. For float, it has parts of 16 bits and a last one of
// 24: its multiple, below 2^-25, is rounded by 2^-50 at most, and no float in this range is nearer to a multiple
// of pi / 2 than 2^-27.9.
template <class Numbers>
ROBCOGEN_INLINE void reduce(const Numbers& x, const Numbers& k, Numbers& r, Numbers& rest) noexcept {
  if constexpr (kIsSingle<Numbers>) {
    Numbers excess;
    const Numbers first = as_rounded(x - k * 0x1.921ep+0f);  // exact
    r = difference<Numbers>(first, k * 0x1.b544p-16f, excess);
    rest = k * 0x1.0b4612p-34f + as_rounded(excess);
  } else {
    Numbers excess1, excess2;
    const Numbers first = as_rounded(x - k * 0x1.921fb54400000p+0);  // exact
    const Numbers second = difference<Numbers>(first, k * 0x1.0b4611a600000p-34, excess1);
    r = difference<Numbers>(second, k * 0x1.3198a2e000000p-69, excess2);
    rest = k * 0x1.b839a252049c1p-104 + (excess1 + excess2);
  }
}

// Sine and cosine of r - rest, |r| <= pi / 4, for double within 0.8 ulp: the rounding error of 1 - z / 2 is added back.
// For float it is not, and the cosine is within 1.2 ulp.
template <class Numbers>
ROBCOGEN_INLINE void of_reduced(const Numbers& r, const Numbers& rest, Numbers& sine, Numbers& cosine) noexcept {
  constexpr Element<Numbers> kHalf = 0.5, kOne = 1.0;
  const Numbers z = r * r, half = kHalf * z, one_less = as_rounded(kOne - half);
  sine = r - (z * r * rest_of_sine(z) + one_less * rest);
  if constexpr (kIsSingle<Numbers>)
    cosine = one_less + (r * rest + z * z * rest_of_cosine(z));
  else
    cosine = one_less + (((as_rounded(kOne - one_less) - half) + r * rest) + z * z * rest_of_cosine(z));
}
#endif

// Adding kRound rounds a number to an integer k: the last bits of the sum are the last bits of k.
template <class Scalar>
constexpr auto kRound = constant<Scalar>(0x1.8p23f + 0x1p8f, 0x1.8p52 + 0x1p16);

// bits_of_integer is below kBeyond for |k| <= 2^16 (for float 2^8), and not below it for other numbers and NaN.
template <class Scalar>
constexpr BitsOfOne<Scalar> kBeyond = 1 << (std::is_same_v<Scalar, float> ? 9 : 17);
template <class Numbers>
ROBCOGEN_INLINE Bits<Numbers> bits_of_integer(const Numbers& rounded) noexcept {
  // The bits of 0x1.8p23f and 0x1.8p52.
  constexpr BitsOfOne<Element<Numbers>> kNone = kIsSingle<Numbers> ? 0x4b400000 : 0x4338000000000000;
  return bits(rounded) ^ kNone;
}

template <class Numbers>
ROBCOGEN_INLINE Numbers quarter_turns(const Numbers& x) noexcept {
  constexpr auto kTwoByPi = constant<Element<Numbers>>(0x1.45f306p-1f, 0x1.45f306dc9c883p-1);
  return as_rounded(x * kTwoByPi + kRound<Element<Numbers>>);
}

// Returns bits whose last ones are those of the integer. `beyond` gets bits from kBeyond on for x beyond the range of
// the polynomials, which is |x| of about 1e5, for float 400.
template <class Numbers>
ROBCOGEN_INLINE Bits<Numbers> noted(const Numbers& rounded, Bits<Numbers>& beyond) noexcept {
  const Bits<Numbers> k = bits_of_integer(rounded);
  beyond |= k;
  return k;
}

// For elements that are known to be in the range.
struct NoneBeyond {};
template <class Numbers>
ROBCOGEN_INLINE Bits<Numbers> noted(const Numbers& rounded, NoneBeyond&) noexcept {
  return bits(rounded);
}

// b where the highest bit of `where` is set, otherwise a.
template <class Numbers>
ROBCOGEN_INLINE Numbers chosen(const Bits<Numbers>& where, const Numbers& a, const Numbers& b) noexcept {
#if defined(__AVX__) && ROBCOGEN_HAS_VECTORS
  if constexpr (sizeof(Numbers) == 32) {
    if constexpr (kIsSingle<Numbers>)
      return __builtin_ia32_blendvps256(a, b, numbers<Numbers>(where));
    else
      return __builtin_ia32_blendvpd256(a, b, numbers<Numbers>(where));
  }
#endif
  constexpr int kHighest = 8 * static_cast<int>(sizeof(Element<Numbers>)) - 1;
  return numbers<Numbers>(bits(a) ^ ((bits(a) ^ bits(b)) & -(where >> kHighest)));
}

// The sine of a zero keeps its sign.
template <class Numbers, class Beyond>
ROBCOGEN_INLINE void polynomials(const Numbers& x, Numbers& sine, Numbers& cosine, Beyond& beyond) noexcept {
  const Numbers rounded = quarter_turns(x);
  const Bits<Numbers> k = noted(rounded, beyond);
  Numbers r, rest, sin_r, cos_r;
  reduce<Numbers>(x, rounded - kRound<Element<Numbers>>, r, rest);
  of_reduced<Numbers>(r, rest, sin_r, cos_r);

  // In odd quadrants sine and cosine are exchanged: each gets the value of the other.
  constexpr int kHighest = 8 * static_cast<int>(sizeof(Element<Numbers>)) - 1;
  const Bits<Numbers> odd = k << kHighest, half_turn = k >> 1 << kHighest;
  const Bits<Numbers> sine_bits = bits(chosen(odd, sin_r, cos_r)) ^ half_turn;
  sine = numbers<Numbers>(sine_bits);
  cosine = numbers<Numbers>((bits(sin_r) ^ bits(cos_r) ^ odd) ^ sine_bits);
}

// Bound of the root of the sum of squares of angles, up to which the polynomials hold for each angle and for sums of
// three.
template <class Scalar>
constexpr auto kSmall = constant<Scalar>(120, 3e4);

// Whether any element has a bit from kBeyond<Scalar> on.
template <class Scalar, class Integers>
ROBCOGEN_INLINE bool any_beyond(const Integers& b) noexcept {
#if defined(__AVX__) && ROBCOGEN_HAS_VECTORS
  if constexpr (sizeof(b) == 32) {
    typedef long long Signed __attribute__((vector_size(32)));
    return !__builtin_ia32_ptestz256((Signed)b, (Signed)(b ^ b ^ ~(kBeyond<Scalar> - 1)));
  }
#endif
  // In parts of 64 bits, which hold two elements of 32.
  constexpr int kBits = 8 * static_cast<int>(sizeof(Scalar));
  using Part = std::conditional_t<sizeof(b) % sizeof(std::uint64_t) == 0, std::uint64_t, BitsOfOne<Scalar>>;
  Part parts[sizeof(b) / sizeof(Part)], any = 0;
  std::memcpy(parts, &b, sizeof(b));
  for (const Part part : parts) any |= part;
  if constexpr (sizeof(Part) > sizeof(Scalar)) any = any >> kBits | (any & ((Part(1) << kBits) - 1));
  return any >= kBeyond<Scalar>;
}

}  // namespace lanes
}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
#undef ROBCOGEN_FUSES
#undef ROBCOGEN_FMA
#undef ROBCOGEN_FMA512
#undef ROBCOGEN_ALL_pd
#undef ROBCOGEN_ALL_ps
