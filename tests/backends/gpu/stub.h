// Just enough of CUDA and of HIP for clang to compile text for GPUs without either: a check of the text, not a build.
#pragma once

#define ROBCOGEN_GPU_STUB
#define __CUDACC_RTC__
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
#define __forceinline__ inline __attribute__((always_inline))
#define __launch_bounds__(threads) __attribute__((launch_bounds(threads)))

struct RobcogenStubIndex {
  unsigned x, y;
};
#if defined(__HIP__)
#define blockIdx                                                \
  (RobcogenStubIndex{                                           \
      static_cast<unsigned>(__builtin_amdgcn_workgroup_id_x()), \
      static_cast<unsigned>(__builtin_amdgcn_workgroup_id_y())})
#define threadIdx (RobcogenStubIndex{static_cast<unsigned>(__builtin_amdgcn_workitem_id_x()), 0})
#define blockDim (RobcogenStubIndex{128, 1})
#else
#define blockIdx      \
  (RobcogenStubIndex{ \
      static_cast<unsigned>(__nvvm_read_ptx_sreg_ctaid_x()), static_cast<unsigned>(__nvvm_read_ptx_sreg_ctaid_y())})
#define threadIdx (RobcogenStubIndex{static_cast<unsigned>(__nvvm_read_ptx_sreg_tid_x()), 0})
#define blockDim (RobcogenStubIndex{static_cast<unsigned>(__nvvm_read_ptx_sreg_ntid_x()), 1})
#endif

#define ROBCOGEN_STUB static inline __host__ __device__
ROBCOGEN_STUB float fmaf(float a, float b, float c) {
  return __builtin_fmaf(a, b, c);
}
ROBCOGEN_STUB double fma(double a, double b, double c) {
  return __builtin_fma(a, b, c);
}
ROBCOGEN_STUB float sqrtf(float x) {
  return __builtin_sqrtf(x);
}
ROBCOGEN_STUB double sqrt(double x) {
  return __builtin_sqrt(x);
}
ROBCOGEN_STUB void* memcpy(void* to, const void* from, __SIZE_TYPE__ count) {
  return __builtin_memcpy(to, from, count);
}
__device__ __host__ float atan2f(float y, float x);
__device__ __host__ double atan2(double y, double x);
#undef ROBCOGEN_STUB

// How threads of a warp exchange numbers.
#if defined(__HIP__)
__device__ inline float __shfl(float x, int lane, int size) {
  const int to = (static_cast<int>(threadIdx.x) & ~(size - 1)) + (lane & (size - 1));
  return __builtin_bit_cast(float, __builtin_amdgcn_ds_bpermute(4 * to, __builtin_bit_cast(int, x)));
}
#else
__device__ inline float __shfl_sync(unsigned threads, float x, int lane, int size) {
  return __nvvm_shfl_sync_idx_f32(threads, x, lane, ((32 - size) << 8) | 31);
}
__device__ inline void __syncwarp() {
  __nvvm_bar_warp_sync(0xffffffffU);
}
#endif

// What the library calls to start kernels by HIP.
#if defined(__HIP__)
struct dim3 {
  unsigned x, y, z;
  dim3(unsigned x_, unsigned y_ = 1, unsigned z_ = 1) : x(x_), y(y_), z(z_) {}
};
enum hipError_t { hipSuccess, hipErrorNoBinaryForGpu, hipErrorInvalidDeviceFunction, hipErrorUnknown };
typedef struct RobcogenStubStream* hipStream_t;
hipError_t hipLaunchKernel(
    const void* kernel,
    dim3 blocks,
    dim3 threads,
    void** arguments,
    __SIZE_TYPE__ shared,
    hipStream_t);
#endif
