// The macros in which functions for GPUs are written: one text that compiles as CUDA, HIP, OpenCL C, C99 and C++17.
//
// In C++, CUDA and HIP, functions are templates of the scalar REAL and of their arrays, which are pointers or anything
// else with operator[] and operator+, such as Strided of arrays.h. In C and OpenCL C, REAL is float, or double if
// ROBCOGEN_GPU_DOUBLE is defined; an array is a pointer and a stride: two arguments, element k is at a[k * stride].
#ifndef ROBCOGEN_GPU_DIALECT_H
#define ROBCOGEN_GPU_DIALECT_H

// Where the text runs: functions for the device and the host, kernels, and the index of a thread. On the host, a kernel
// is a function that runs through all states.
#if defined(__OPENCL_VERSION__)
#define RC_DEVICE static inline
#define RC_KERNEL_TYPE __kernel void
#define RC_FIRST_STATE ((int)get_global_id(0))
#define RC_NEXT_STATE(i, n) (n)
#define RC_FIRST_RUN ((int)get_global_id(1))
#define RC_NEXT_RUN(i, n) (n)
#elif defined(__CUDACC__) || defined(__CUDA__) || defined(__HIP__)
#if defined(__HIP__) && !defined(__HIPCC_RTC__) && !defined(ROBCOGEN_GPU_STUB)
#include <hip/hip_runtime.h>
#endif
#define RC_DEVICE __host__ __device__ __forceinline__
#define RC_KERNEL_TYPE __global__ void __launch_bounds__(128)
#define RC_FIRST_STATE ((int)(blockIdx.x * blockDim.x + threadIdx.x))
#define RC_NEXT_STATE(i, n) (n)
#define RC_FIRST_RUN ((int)blockIdx.y)
#define RC_NEXT_RUN(i, n) (n)
#elif defined(__cplusplus)
#define RC_DEVICE inline
#define RC_KERNEL_TYPE inline void
#define RC_FIRST_STATE 0
#define RC_NEXT_STATE(i, n) ((i) + 1)
#define RC_FIRST_RUN 0
#define RC_NEXT_RUN(i, n) ((i) + 1)
#else
#define RC_DEVICE static inline
#define RC_KERNEL_TYPE static inline void
#define RC_FIRST_STATE 0
#define RC_NEXT_STATE(i, n) ((i) + 1)
#define RC_FIRST_RUN 0
#define RC_NEXT_RUN(i, n) ((i) + 1)
#endif

#define RC_FOR_STATES(n) for (int rc_state = RC_FIRST_STATE; rc_state < (n); rc_state = RC_NEXT_STATE(rc_state, n))
// For kernels in which neighbouring threads share a state. All threads of a warp take part, so those behind the last
// state compute it once more.
#define RC_FOR_STATES_IN_LANES(n, lanes)                                                                 \
  for (int rc_state = RC_FIRST_STATE / (lanes) < (n) ? RC_FIRST_STATE / (lanes) : (n)-1; rc_state < (n); \
       rc_state = RC_NEXT_STATE(rc_state, n))
// For kernels that compute several groups of columns of each state, one in each thread.
#define RC_FOR_RUNS(n) for (int rc_run = RC_FIRST_RUN; rc_run < (n); rc_run = RC_NEXT_RUN(rc_run, n))

#include "robcogen/gpu/scalar.h"

// Where element k of state i is: (i >> shift) * outer + (i & ((1 << shift) - 1)) + k * element. An argument of kernels
// whose layout is chosen when the program runs.
typedef struct robcogen_gpu_strides {
  int shift, outer, element;
} robcogen_gpu_strides;

// An array that a function keeps to itself is a plain one: only its type is a macro.
#if defined(__cplusplus)

#include "robcogen/gpu/arrays.h"
#include "robcogen/gpu/lanes.h"

#define RC(number) (REAL(number))
#define RC_NAN (REAL(__builtin_nanf("")))
#define RC_INFINITY (REAL(__builtin_inff()))
#define RC_SINCOS(x, s, c) \
  REAL s, c;               \
  robcogen::gpu::sincos(REAL(x), s, c)
#define RC_SIN(x) robcogen::gpu::sine(REAL(x))
#define RC_COS(x) robcogen::gpu::cosine(REAL(x))
#define RC_SINCOS_IN_LANES(count, x, s, c) \
  robcogen::gpu::Lanes<REAL, count> s, c;  \
  robcogen::gpu::sincos(x, s, c)
#define RC_SQRT(x) robcogen::gpu::square_root_of<REAL>(x)
#define RC_ATAN2(y, x) robcogen::gpu::arc_tangent(REAL(y), REAL(x))
#define RC_QUOTIENT(a, b) robcogen::gpu::quotient_of<REAL>(a, b)

#define RC_FUNCTION(count)                \
  template <class REAL, RC_ARRAYS##count> \
  RC_DEVICE void
#define RC_CALL(function) function<REAL>
#define RC_IN(i, a) const RC_ARRAY##i a
#define RC_OUT(i, a) const RC_ARRAY##i a
#define RC_AT(a, k) a[k]
#define RC_PASS(a) a
#define RC_FROM(a, k) (a) + (k)
#define RC_UNUSED(a) (void)a

#define RC_KERNEL(count)                  \
  template <class REAL, RC_ARRAYS##count> \
  RC_KERNEL_TYPE
#define RC_STATES_IN(i, a) const RC_ARRAY##i a##__states
#define RC_STATES_OUT(i, a) const RC_ARRAY##i a##__states
#define RC_STATE_IN(a, size) const auto a = a##__states.template state<size>(rc_state)
#define RC_STATE_OUT(a, size) const auto a = a##__states.template state<size>(rc_state)

#define RC_ARRAYS1 class RC_ARRAY1
#define RC_ARRAYS2 RC_ARRAYS1, class RC_ARRAY2
#define RC_ARRAYS3 RC_ARRAYS2, class RC_ARRAY3
#define RC_ARRAYS4 RC_ARRAYS3, class RC_ARRAY4
#define RC_ARRAYS5 RC_ARRAYS4, class RC_ARRAY5
#define RC_ARRAYS6 RC_ARRAYS5, class RC_ARRAY6
#define RC_ARRAYS7 RC_ARRAYS6, class RC_ARRAY7
#define RC_ARRAYS8 RC_ARRAYS7, class RC_ARRAY8
#define RC_ARRAYS9 RC_ARRAYS8, class RC_ARRAY9
#define RC_ARRAYS10 RC_ARRAYS9, class RC_ARRAY10
#define RC_ARRAYS11 RC_ARRAYS10, class RC_ARRAY11
#define RC_ARRAYS12 RC_ARRAYS11, class RC_ARRAY12
#define RC_ARRAYS13 RC_ARRAYS12, class RC_ARRAY13
#define RC_ARRAYS14 RC_ARRAYS13, class RC_ARRAY14
#define RC_ARRAYS15 RC_ARRAYS14, class RC_ARRAY15
#define RC_ARRAYS16 RC_ARRAYS15, class RC_ARRAY16
#define RC_ARRAYS17 RC_ARRAYS16, class RC_ARRAY17
#define RC_ARRAYS18 RC_ARRAYS17, class RC_ARRAY18
#define RC_ARRAYS19 RC_ARRAYS18, class RC_ARRAY19
#define RC_ARRAYS20 RC_ARRAYS19, class RC_ARRAY20
#define RC_ARRAYS21 RC_ARRAYS20, class RC_ARRAY21
#define RC_ARRAYS22 RC_ARRAYS21, class RC_ARRAY22
#define RC_ARRAYS23 RC_ARRAYS22, class RC_ARRAY23
#define RC_ARRAYS24 RC_ARRAYS23, class RC_ARRAY24

#else

#if defined(ROBCOGEN_GPU_DOUBLE)
#define REAL double
#define RC(number) number
#define RC_NAMED(function) function
#else
#define REAL float
#define RC(number) number##f
#define RC_NAMED(function) function##f
#endif
// Of the arrays of functions; kernels of OpenCL have theirs in global memory. Define it as __private to call functions
// with arrays of a thread.
#if !defined(ROBCOGEN_GPU_SPACE)
#if defined(__OPENCL_VERSION__)
#define ROBCOGEN_GPU_SPACE __global
#else
#define ROBCOGEN_GPU_SPACE
#endif
#endif

#define RC_NAN ((REAL)NAN)
#define RC_INFINITY ((REAL)INFINITY)
#define RC_SINCOS(x, s, c) \
  REAL s, c;               \
  RC_NAMED(robcogen_gpu_sincos)((x), &s, &c)
#define RC_SIN(x) RC_NAMED(robcogen_gpu_sine)(x)
#define RC_COS(x) RC_NAMED(robcogen_gpu_cosine)(x)
#define RC_SQRT(x) RC_NAMED(robcogen_gpu_square_root)(x)
#define RC_ATAN2(y, x) RC_NAMED(robcogen_gpu_arc_tangent)(y, x)
#define RC_QUOTIENT(a, b) RC_NAMED(robcogen_gpu_quotient)(a, b)

#define RC_FUNCTION(count) RC_DEVICE void
#define RC_CALL(function) function
#define RC_IN(i, a) ROBCOGEN_GPU_SPACE const REAL *restrict a, const int a##__stride
#define RC_OUT(i, a) ROBCOGEN_GPU_SPACE REAL *restrict a, const int a##__stride
#define RC_AT(a, k) a[(k)*a##__stride]
#define RC_PASS(a) a, a##__stride
#define RC_FROM(a, k) (a) + (k)*a##__stride, a##__stride
#define RC_UNUSED(a) (void)a, (void)a##__stride

// With ROBCOGEN_GPU_TILES, all arrays of kernels are tiles, and the compiler knows their strides.
#if defined(ROBCOGEN_GPU_TILES)
#define RC_OFFSET(a, size) (rc_state / 32 * (32 * (size)) + rc_state % 32)
#define RC_STRIDE(a) ((void)a##__strides, 32)
#else
#define RC_OFFSET(a, size) \
  ((rc_state >> a##__strides.shift) * a##__strides.outer + (rc_state & ((1 << a##__strides.shift) - 1)))
#define RC_STRIDE(a) a##__strides.element
#endif
#define RC_KERNEL(count) RC_KERNEL_TYPE
#define RC_STATES_IN(i, a) ROBCOGEN_GPU_SPACE const REAL *restrict a##__data, const robcogen_gpu_strides a##__strides
#define RC_STATES_OUT(i, a) ROBCOGEN_GPU_SPACE REAL *restrict a##__data, const robcogen_gpu_strides a##__strides
#define RC_STATE_IN(a, size)                                               \
  ROBCOGEN_GPU_SPACE const REAL* const a = a##__data + RC_OFFSET(a, size); \
  const int a##__stride = RC_STRIDE(a)
#define RC_STATE_OUT(a, size)                                        \
  ROBCOGEN_GPU_SPACE REAL* const a = a##__data + RC_OFFSET(a, size); \
  const int a##__stride = RC_STRIDE(a)

#endif

#endif
