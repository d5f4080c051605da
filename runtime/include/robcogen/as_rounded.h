// Values that a compiler must treat as rounded, also under -ffast-math.
#pragma once

#include <cstring>
#include <type_traits>
#include <utility>

#if defined(__GNUC__)
#define ROBCOGEN_INLINE static inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE static inline
#endif

// Defined if the compiler is known not to reassociate sums. gcc reports this by a macro since version 12, clang does
// not.
#if defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__) && !defined(__INTEL_COMPILER) && !defined(__NVCOMPILER)
#if !defined(__ASSOCIATIVE_MATH__)
#define ROBCOGEN_KEEPS_ORDER 1
#endif
#elif defined(_MSC_VER) && !defined(__clang__) && !defined(_M_FP_FAST)
#define ROBCOGEN_KEEPS_ORDER 1
#endif

// Assembly constraints for registers that hold a number or a compiler vector, and the smallest size in bytes of a
// vector that fits such a register. "m" is memory, which is valid on any processor.
#if defined(__AVX512F__)
#define ROBCOGEN_REGISTER_OF_DOUBLE "+v"
#define ROBCOGEN_REGISTER_OF_FLOAT "+v"
#define ROBCOGEN_REGISTER_OF_VECTOR "+v"
#define ROBCOGEN_SMALLEST_VECTOR 16
#elif defined(__SSE2__)
#define ROBCOGEN_REGISTER_OF_DOUBLE "+x"
#define ROBCOGEN_REGISTER_OF_FLOAT "+x"
#define ROBCOGEN_REGISTER_OF_VECTOR "+x"
#define ROBCOGEN_SMALLEST_VECTOR 16
#elif defined(__aarch64__)
#define ROBCOGEN_REGISTER_OF_DOUBLE "+w"
#define ROBCOGEN_REGISTER_OF_FLOAT "+w"
#define ROBCOGEN_REGISTER_OF_VECTOR "+w"
#define ROBCOGEN_SMALLEST_VECTOR 8
#elif defined(__arm__)
#if defined(__ARM_FP) && (__ARM_FP & 8)
#define ROBCOGEN_REGISTER_OF_DOUBLE "+w"
#else
#define ROBCOGEN_REGISTER_OF_DOUBLE "+r"
#endif
#if defined(__ARM_FP) && (__ARM_FP & 4)
#define ROBCOGEN_REGISTER_OF_FLOAT "+t"
#else
#define ROBCOGEN_REGISTER_OF_FLOAT "+r"
#endif
#elif defined(__riscv_flen) && __riscv_flen >= 64
#define ROBCOGEN_REGISTER_OF_DOUBLE "+f"
#define ROBCOGEN_REGISTER_OF_FLOAT "+f"
#else
#define ROBCOGEN_REGISTER_OF_DOUBLE "+m"
#define ROBCOGEN_REGISTER_OF_FLOAT "+m"
#endif

namespace robcogen {
namespace {  // separate in each file, like lanes
namespace lanes {

// Returns x and hides its computation from the compiler, which with -ffast-math, -Ofast or -funsafe-math-optimizations
// would replace (a + b) - b by a and lose intended rounding. Costs no instruction.
#if defined(ROBCOGEN_KEEPS_ORDER)
template <class Numbers>
ROBCOGEN_INLINE Numbers as_rounded(const Numbers& x) noexcept {
  return x;
}
#elif defined(__GNUC__)
ROBCOGEN_INLINE double as_rounded(double x) noexcept {
  __asm__("" : ROBCOGEN_REGISTER_OF_DOUBLE(x));
  return x;
}
ROBCOGEN_INLINE float as_rounded(float x) noexcept {
  __asm__("" : ROBCOGEN_REGISTER_OF_FLOAT(x));
  return x;
}

template <class Vector, int... kElement>
ROBCOGEN_INLINE Vector each_as_rounded(const Vector& x, std::integer_sequence<int, kElement...>) noexcept {
  return Vector{as_rounded(x[kElement])...};
}

template <class Vector>
ROBCOGEN_INLINE Vector as_rounded(const Vector& x) noexcept {
#if defined(ROBCOGEN_REGISTER_OF_VECTOR)
  if constexpr (sizeof(Vector) >= ROBCOGEN_SMALLEST_VECTOR) {
    Vector result = x;
    __asm__("" : ROBCOGEN_REGISTER_OF_VECTOR(result));
    return result;
  }
#endif
  constexpr int kSize = static_cast<int>(sizeof(Vector) / sizeof(x[0]));
  return each_as_rounded(x, std::make_integer_sequence<int, kSize>());
}
#else  // through memory
template <class Number>
ROBCOGEN_INLINE Number as_rounded(Number x) noexcept {
  volatile Number stored = x;
  return stored;
}
#endif

}  // namespace lanes
}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
#undef ROBCOGEN_REGISTER_OF_DOUBLE
#undef ROBCOGEN_REGISTER_OF_FLOAT
#undef ROBCOGEN_REGISTER_OF_VECTOR
#undef ROBCOGEN_SMALLEST_VECTOR
#undef ROBCOGEN_KEEPS_ORDER
