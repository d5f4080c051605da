// Sines, quotients and roots of the functions for GPUs, without branches: included by dialect.h.
//
// Sines are those of the runtime: sine_polynomials.h says how they are computed. Large angles are computed in the same
// way: the error of sine and cosine is below 1e-7 for angles up to 1e4 rad in float, and below 3e-16 for angles up to
// 1e5 rad in double; it grows beyond.
#ifndef ROBCOGEN_GPU_SCALAR_H
#define ROBCOGEN_GPU_SCALAR_H

#if defined(__OPENCL_VERSION__)
#if defined(ROBCOGEN_GPU_DOUBLE)
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define RC_HAS_DOUBLE 1
#else
#define RC_HAS_DOUBLE 0
#endif
#define RC_FMAF(a, b, c) fma(a, b, c)
#define RC_FMA(a, b, c) fma(a, b, c)
#define RC_SQRTF(x) sqrt(x)
#define RC_ATAN2F(y, x) atan2(y, x)
#define RC_LOW_BITSF(x) as_uint(x)
#define RC_LOW_BITS(x) ((uint)as_ulong(x))
typedef uint robcogen_gpu_bits;
#else
#define RC_HAS_DOUBLE 1
#if !defined(__CUDACC_RTC__) && !defined(__HIPCC_RTC__)
#include <math.h>
#include <string.h>
#endif
#define RC_FMAF(a, b, c) fmaf(a, b, c)
#define RC_FMA(a, b, c) fma(a, b, c)
#define RC_SQRTF(x) sqrtf(x)
#define RC_ATAN2F(y, x) atan2f(y, x)
#define RC_LOW_BITSF(x) robcogen_gpu_low_bitsf(x)
#define RC_LOW_BITS(x) robcogen_gpu_low_bits(x)
typedef unsigned robcogen_gpu_bits;

RC_DEVICE unsigned robcogen_gpu_low_bitsf(float x) {
  unsigned bits;
  memcpy(&bits, &x, sizeof(bits));
  return bits;
}

RC_DEVICE unsigned robcogen_gpu_low_bits(double x) {
  unsigned long long bits;
  memcpy(&bits, &x, sizeof(bits));
  return (unsigned)bits;
}
#endif

// `end`: that of the names of functions of these numbers.
#define RC_SINE_AND_COSINE(number, end)                 \
  RC_DEVICE number robcogen_gpu_sine##end(number x) {   \
    number s, c;                                        \
    robcogen_gpu_sincos##end(x, &s, &c);                \
    return s;                                           \
  }                                                     \
  RC_DEVICE number robcogen_gpu_cosine##end(number x) { \
    number s, c;                                        \
    robcogen_gpu_sincos##end(x, &s, &c);                \
    return c;                                           \
  }

// Adding 1.5 * 2^23 rounds 2 / pi * x to an integer, whose last bits are those of the sum: the quarter turn.
RC_DEVICE void robcogen_gpu_sincosf(float x, float* sine, float* cosine) {
  const float rounded = RC_FMAF(x, 0x1.45f306p-1f, 0x1.8p23f), k = rounded - 0x1.8p23f;
  const robcogen_gpu_bits turns = RC_LOW_BITSF(rounded);
  const float r = RC_FMAF(k, 0x1.777a5cp-25f, RC_FMAF(k, -0x1.921fb6p+0f, x)), z = r * r;
  const float s = RC_FMAF(z * r, -RC_FMAF(z, -RC_FMAF(z, -0x1.994374p-13f, 0x1.11074p-7f), 0x1.555546p-3f), r);
  const float c =
      RC_FMAF(z, RC_FMAF(z, RC_FMAF(z, RC_FMAF(z, 0x1.9a01f8p-16f, -0x1.6c0c84p-10f), 0x1.55554ap-5f), -0.5f), 1.0f);
  const float a = turns & 1 ? c : s, b = turns & 1 ? s : c;
  *sine = turns & 2 ? -a : a;
  *cosine = (turns + 1) & 2 ? -b : b;
}

RC_SINE_AND_COSINE(float, f)

RC_DEVICE float robcogen_gpu_square_rootf(float x) {
#if defined(__CUDA_ARCH__)
  float root;
  asm("sqrt.approx.f32 %0, %1;" : "=f"(root) : "f"(x));
  return root;
#else
  return RC_SQRTF(x);
#endif
}

RC_DEVICE float robcogen_gpu_arc_tangentf(float y, float x) {
  return RC_ATAN2F(y, x);
}

// A reciprocal with twice the digits of the estimate r (Newton's method).
RC_DEVICE float robcogen_gpu_refinedf(float b, float r) {
  return RC_FMAF(r, RC_FMAF(-b, r, 1.0f), r);
}

// Within 2 units in the last place on GPUs, where division by zero gives NaN.
RC_DEVICE float robcogen_gpu_quotientf(float a, float b) {
#if defined(__CUDA_ARCH__)
  float r;
  asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(r) : "f"(b));
  return a * robcogen_gpu_refinedf(b, r);
#elif defined(__HIP_DEVICE_COMPILE__)
  return a * robcogen_gpu_refinedf(b, __builtin_amdgcn_rcpf(b));
#else
  return a / b;
#endif
}

#if RC_HAS_DOUBLE
RC_DEVICE void robcogen_gpu_sincos(double x, double* sine, double* cosine) {
  const double rounded = RC_FMA(x, 0x1.45f306dc9c883p-1, 0x1.8p52), k = rounded - 0x1.8p52;
  const robcogen_gpu_bits turns = RC_LOW_BITS(rounded);
  const double first = RC_FMA(k, -0x1.921fb54442d18p+0, x), r = RC_FMA(k, -0x1.1a62633100000p-54, first);
  const double rest = RC_FMA(k, 0x1.1701b839a2520p-88, RC_FMA(k, 0x1.1a62633100000p-54, r - first));
  const double z = r * r, square = RC_FMA(r, r, -((r + r) * rest));
  double p = RC_FMA(-z, 1.5896795653837948e-10, 2.5050758115276912e-08);
  p = RC_FMA(-z, RC_FMA(-z, RC_FMA(-z, p, 2.755731369191808e-06), 0.00019841269829807808), 0.008333333333322413);
  const double s = r - RC_FMA(z * r, RC_FMA(-z, p, 0.16666666666666632), rest);
  p = RC_FMA(z, RC_FMA(z, -1.1359647814765908e-11, 2.087572327348275e-09), -2.7557314352335047e-07);
  p = RC_FMA(z, RC_FMA(z, RC_FMA(z, p, 2.4801587289482194e-05), -0.0013888888888874125), 0.0416666666666666);
  const double c = RC_FMA(square, RC_FMA(square, p, -0.5), 1.0);
  const double a = turns & 1 ? c : s, b = turns & 1 ? s : c;
  *sine = turns & 2 ? -a : a;
  *cosine = (turns + 1) & 2 ? -b : b;
}

RC_SINE_AND_COSINE(double, )

RC_DEVICE double robcogen_gpu_square_root(double x) {
  return sqrt(x);
}

RC_DEVICE double robcogen_gpu_arc_tangent(double y, double x) {
  return atan2(y, x);
}

RC_DEVICE double robcogen_gpu_refined(double b, double r) {
  return RC_FMA(r, RC_FMA(-b, r, 1.0), r);
}

// The estimates of GPUs have 20 bits or more.
RC_DEVICE double robcogen_gpu_quotient(double a, double b) {
#if defined(__CUDA_ARCH__)
  double r;
  asm("rcp.approx.ftz.f64 %0, %1;" : "=d"(r) : "d"(b));
  return a * robcogen_gpu_refined(b, robcogen_gpu_refined(b, r));
#elif defined(__HIP_DEVICE_COMPILE__)
  return a * robcogen_gpu_refined(b, robcogen_gpu_refined(b, __builtin_amdgcn_rcp(b)));
#else
  return a / b;
#endif
}
#endif

#if defined(__cplusplus)
namespace robcogen::gpu {

// Overloads in place of the ends of names.
#define RC_OVERLOADS(number, end)                         \
  RC_DEVICE void sincos(number x, number& s, number& c) { \
    robcogen_gpu_sincos##end(x, &s, &c);                  \
  }                                                       \
  RC_DEVICE number sine(number x) {                       \
    return robcogen_gpu_sine##end(x);                     \
  }                                                       \
  RC_DEVICE number cosine(number x) {                     \
    return robcogen_gpu_cosine##end(x);                   \
  }                                                       \
  RC_DEVICE number square_root(number x) {                \
    return robcogen_gpu_square_root##end(x);              \
  }                                                       \
  RC_DEVICE number arc_tangent(number y, number x) {      \
    return robcogen_gpu_arc_tangent##end(y, x);           \
  }                                                       \
  RC_DEVICE number quotient(number a, number b) {         \
    return robcogen_gpu_quotient##end(a, b);              \
  }
RC_OVERLOADS(float, f)
RC_OVERLOADS(double, )
#undef RC_OVERLOADS

}  // namespace robcogen::gpu
#endif

#endif
