// The processor levels that generated code is compiled for, and the level of this machine.
#pragma once

// Whether code can be compiled for several processors, with a choice when the program runs.
#if defined(__x86_64__) && defined(__GNUC__)
#define ROBCOGEN_HAS_LEVELS 1
#else
#define ROBCOGEN_HAS_LEVELS 0
#endif

// Whether kernels of one state are compiled for several levels: the build defines which, and its own options are for a
// lower one.
#if ROBCOGEN_HAS_LEVELS && (defined(ROBCOGEN_WITH_AVX2) || defined(ROBCOGEN_WITH_AVX512)) && !defined(__AVX__)
#define ROBCOGEN_CHOOSES_LEVEL 1
#else
#define ROBCOGEN_CHOOSES_LEVEL 0
#endif

namespace robcogen {

// baseline: the options of the library. avx2: AVX2 and FMA (x86-64-v3), four doubles or eight floats at once. avx512:
// AVX-512 F, DQ and VL, eight doubles or sixteen floats at once.
enum class Level { baseline, avx2, avx512 };

// The highest level that this machine has. Reads a variable that is set before `main`.
inline Level best_level() noexcept {
#if ROBCOGEN_HAS_LEVELS
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return Level::baseline;
  const bool has_512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  return has_512 && __builtin_cpu_supports("avx512vl") ? Level::avx512 : Level::avx2;
#else
  return Level::baseline;
#endif
}

// The given level, or the highest one that is available.
inline Level available(Level most) noexcept {
  const Level best = best_level();
  return most < best ? most : best;
}

}  // namespace robcogen
