// Sines and cosines of many angles at once: one polynomial in the lanes of the processor's vectors.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "robcogen/sincos.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#define ROBCOGEN_RARE static __attribute__((noinline, cold, unused))
#else
#define ROBCOGEN_INLINE static inline
#define ROBCOGEN_RARE static
#endif

namespace robcogen {
namespace lanes {

// Four lanes at most: putting eight angles into one vector costs more than computing two vectors. Functions of this
// namespace have internal linkage, for files of one program may be compiled for different processors.

#if !defined(__GNUC__)
using Doubles = double;
using Bits = std::int64_t;
#elif defined(__AVX2__)
typedef double Doubles __attribute__((vector_size(32)));
typedef std::int64_t Bits __attribute__((vector_size(32)));
#else
typedef double Doubles __attribute__((vector_size(16)));
typedef std::int64_t Bits __attribute__((vector_size(16)));
#endif

constexpr int kLanes = static_cast<int>(sizeof(Doubles) / sizeof(double));
constexpr double kMost = 1e5;  // rad: the reduction of larger angles would need more parts of pi / 2

ROBCOGEN_INLINE Bits bits(const Doubles& x) noexcept {
  Bits b;
  std::memcpy(&b, &x, sizeof(b));
  return b;
}

ROBCOGEN_INLINE Doubles doubles(const Bits& b) noexcept {
  Doubles x;
  std::memcpy(&x, &b, sizeof(x));
  return x;
}

// a - t and what rounding took off it (Knuth 1997, sec. 4.2.2). Exact also where the compiler fuses t = k p, which is
// exact by itself.
ROBCOGEN_INLINE Doubles difference(const Doubles& a, const Doubles& t, Doubles& error) noexcept {
  const Doubles result = a - t;
  const Doubles back = result - a;
  error = (a - (result - back)) - (t + back);
  return result;
}

// |x| <= kMost. Reduced by multiples of pi / 2 in parts of 33 bits, of which a multiple below 2^17 is exact (Cody,
// Waite 1980), to an angle and its tail; minimax polynomials in the angle's square, of relative error 2^-57 and
// absolute error 2^-59 on [-pi/4, pi/4] (Remez exchange, coefficients rounded to double). The result is within 0.8 ulp.
ROBCOGEN_INLINE void sincos(const Doubles& x, Doubles& sine, Doubles& cosine) noexcept {
  const Bits sign = bits(x) & INT64_MIN;
  const Doubles positive = doubles(bits(x) ^ sign);
  // Adding 1.5 2^52 rounds to an integer, that then stands in the last bits.
  const Doubles shifted = positive * 0x1.45f306dc9c883p-1 + 0x1.8p52;
  const Bits quadrant = bits(shifted);
  const Doubles k = shifted - 0x1.8p52;
  Doubles error1, error2;
  const Doubles first = positive - k * 0x1.921fb54400000p+0;  // exact
  const Doubles second = difference(first, k * 0x1.0b4611a600000p-34, error1);
  const Doubles third = difference(second, k * 0x1.3198a2e000000p-69, error2);
  const Doubles rest = (error1 + error2) - k * 0x1.b839a252049c1p-104;
  const Doubles r = third + rest;
  const Doubles tail = (third - r) + rest;

  const Doubles z = r * r, half = 0.5 * z;
  const Doubles s =
      -0.16666666666666632 +
      z * (0.008333333333322413 +
           z * (-0.00019841269829807808 +
                z * (2.755731369191808e-06 + z * (-2.5050758115276912e-08 + z * 1.5896795653837948e-10))));
  const Doubles c =
      0.0416666666666666 +
      z * (-0.0013888888888874125 +
           z * (2.4801587289482194e-05 +
                z * (-2.7557314352335047e-07 + z * (2.087572327348275e-09 + z * -1.1359647814765908e-11))));
  const Doubles sin_r = r + (z * r * s + (tail - half * tail));
  const Doubles one_less = 1.0 - half;
  const Doubles cos_r = one_less + (((1.0 - one_less) - half) + (z * z * c - r * tail));

  const Bits odd = -(quadrant & 1);
  const Bits s_bits = bits(sin_r), c_bits = bits(cos_r), both = (s_bits ^ c_bits) & odd;
  sine = doubles((s_bits ^ both) ^ ((quadrant & 2) << 62) ^ sign);
  cosine = doubles((c_bits ^ both) ^ (((quadrant + 1) & 2) << 62));
}

// What is out of the range of the polynomials, or no number.
template <class Scalar>
ROBCOGEN_RARE void replace_large(const Scalar* x, int size, Scalar* sine, Scalar* cosine) noexcept {
  for (int i = 0; i < size; ++i) {
    if (std::abs(x[i]) <= Scalar(kMost)) continue;
    sine[i] = std::sin(x[i]);
    cosine[i] = std::cos(x[i]);
  }
}

// Lanes beyond the first kUsed are zero.
template <int kUsed, class Scalar, int... kLane>
ROBCOGEN_INLINE Doubles gathered(const Scalar* x, std::integer_sequence<int, kLane...>) noexcept {
  return Doubles{(kLane < kUsed ? static_cast<double>(x[kLane < kUsed ? kLane : 0]) : 0.0)...};
}

// From and to the first kUsed elements; whether all of them are small.
template <int kUsed, class Scalar>
ROBCOGEN_INLINE bool sincos_of_vector(const Scalar* x, Scalar* sine, Scalar* cosine) noexcept {
  const Doubles angles = gathered<kUsed>(x, std::make_integer_sequence<int, kLanes>());
  Doubles s, c;
  sincos(angles, s, c);
  double sines[kLanes], cosines[kLanes];
  std::memcpy(sines, &s, sizeof(s));
  std::memcpy(cosines, &c, sizeof(c));
  bool all_small = true;
  for (int i = 0; i < kUsed; ++i) {
    all_small &= std::abs(x[i]) <= Scalar(kMost);
    sine[i] = static_cast<Scalar>(sines[i]);
    cosine[i] = static_cast<Scalar>(cosines[i]);
  }
  return all_small;
}

// Scalar: double or float. All angles are computed as double, which for float leaves 0.51 ulp.
template <int kSize, class Scalar>
ROBCOGEN_INLINE void sincos(const Scalar* x, Scalar* sine, Scalar* cosine) noexcept {
  constexpr int kWhole = kSize / kLanes * kLanes;
  bool all_small = true;
  for (int i = 0; i < kWhole; i += kLanes) all_small &= sincos_of_vector<kLanes>(x + i, sine + i, cosine + i);
  if constexpr (kWhole < kSize)
    all_small &= sincos_of_vector<kSize - kWhole>(x + kWhole, sine + kWhole, cosine + kWhole);
  if (!all_small) replace_large(x, kSize, sine, cosine);
}

}  // namespace lanes

// Sines and cosines of kSize angles (rad). For double and float within 1 ulp below 1e5 rad, as the C library has them
// beyond, for infinities and for what is no number; the rounding mode must be to nearest. For any other scalar its own
// sin and cos, found by argument-dependent lookup. To be compiled without -ffast-math, as all generated code.
template <class Scalar, int kSize>
class SinCosOf {
 public:
  explicit SinCosOf(const Scalar* angles) {
    if constexpr (std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>) {
      lanes::sincos<kSize>(angles, sin_, cos_);
    } else {
      for (int i = 0; i < kSize; ++i) {
        const SinCos<Scalar> both = robcogen::sincos(angles[i]);
        sin_[i] = both.sin;
        cos_[i] = both.cos;
      }
    }
  }

  SinCos<Scalar> operator[](int i) const { return {sin_[i], cos_[i]}; }

 private:
  Scalar sin_[kSize];
  Scalar cos_[kSize];
};

}  // namespace robcogen

#undef ROBCOGEN_INLINE
#undef ROBCOGEN_RARE
