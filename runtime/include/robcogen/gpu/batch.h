// Arguments and results of functions over many states on a GPU, in C99 and in C++17. No header of CUDA or HIP is
// needed.
#ifndef ROBCOGEN_GPU_BATCH_H
#define ROBCOGEN_GPU_BATCH_H

#include <stddef.h>

#ifdef __cplusplus
#include <cstddef>
extern "C" {
#endif

typedef enum robcogen_gpu_status {
  robcogen_gpu_success = 0,
  robcogen_gpu_negative_count,   // n is negative
  robcogen_gpu_too_large,        // the arrays of n states have 2^31 elements or more
  robcogen_gpu_wrong_stride,     // less than n by element, or less than the elements of a state by state
  robcogen_gpu_misaligned,       // an array is null, or not aligned to its numbers
  robcogen_gpu_no_device_code,   // the library has no code for this device: GPU_ARCHITECTURES
  robcogen_gpu_launch_failed,    // CUDA or HIP did not start the kernel; cudaGetLastError() says why
  robcogen_gpu_small_workspace,  // the workspace is smaller than the function says, null, or misaligned
  robcogen_gpu_wrong_layout      // lower triangles by tile: of a symmetric result, with tiles of all other arrays; a
                                 // result that is the same for all; or no layout
} robcogen_gpu_status;

// Where element k of state i is in an array of states with `size` elements each.
typedef enum robcogen_gpu_layout {
  robcogen_gpu_by_tile = 0,   // data[i / 32 * 32 * size + k * 32 + i % 32]; memory for a multiple of 32 states
  robcogen_gpu_by_element,    // data[k * stride + i]
  robcogen_gpu_by_state,      // data[i * stride + k]; stride 0: size
  robcogen_gpu_same_for_all,  // data[k]; not of a result
  robcogen_gpu_lower_by_tile  // by tile; elements above the diagonal of a symmetric result are not written
} robcogen_gpu_layout;

// An array in the memory of the device, of the numbers that the function takes.
typedef struct robcogen_gpu_array {
  const void* data;
  robcogen_gpu_layout layout;
  ptrdiff_t stride;
} robcogen_gpu_array;

// Memory of the device that the kernels of one function pass numbers through. Calls that run at the same time need one
// each.
typedef struct robcogen_gpu_workspace {
  void* data;
  size_t bytes;
} robcogen_gpu_workspace;

static inline size_t robcogen_gpu_workspace_bytes(ptrdiff_t n, size_t numbers, size_t bytes_of_number) {
  return n <= 0 ? 0 : ((size_t)n + 31) / 32 * 32 * numbers * bytes_of_number;
}

// Defines the functions that return the bytes of a function's workspace for n states, in double and in float: in C, and
// in C++ as a template of the scalar. `elements`: those of one state.
#define ROBCOGEN_GPU_WORKSPACE(function, elements)                    \
  static inline size_t function##_workspace(ptrdiff_t n) {            \
    return robcogen_gpu_workspace_bytes(n, elements, sizeof(double)); \
  }                                                                   \
  static inline size_t function##_workspacef(ptrdiff_t n) {           \
    return robcogen_gpu_workspace_bytes(n, elements, sizeof(float));  \
  }
#define ROBCOGEN_GPU_WORKSPACE_OF(function, elements)                 \
  template <class Scalar>                                             \
  std::size_t function##_workspace(std::ptrdiff_t n) noexcept {       \
    return robcogen_gpu_workspace_bytes(n, elements, sizeof(Scalar)); \
  }

static inline const char* robcogen_gpu_message(robcogen_gpu_status status) {
  switch (status) {
    case robcogen_gpu_success:
      return "success";
    case robcogen_gpu_negative_count:
      return "the number of states is negative";
    case robcogen_gpu_too_large:
      return "an array has 2^31 elements or more";
    case robcogen_gpu_wrong_stride:
      return "a stride is too small";
    case robcogen_gpu_misaligned:
      return "an array is null or misaligned";
    case robcogen_gpu_no_device_code:
      return "the library has no code for this device";
    case robcogen_gpu_launch_failed:
      return "the kernel did not start";
    case robcogen_gpu_small_workspace:
      return "the workspace is too small, null or misaligned";
    case robcogen_gpu_wrong_layout:
      return "an array cannot have this layout: results differ from state to state, and lower triangles are those of "
             "symmetric results, with tiles of all other arrays";
  }
  return "unknown status";
}

#ifdef __cplusplus
}  // extern "C"

namespace robcogen::gpu {

enum class Status {
  success = robcogen_gpu_success,
  negative_count = robcogen_gpu_negative_count,
  too_large = robcogen_gpu_too_large,
  wrong_stride = robcogen_gpu_wrong_stride,
  misaligned = robcogen_gpu_misaligned,
  no_device_code = robcogen_gpu_no_device_code,
  launch_failed = robcogen_gpu_launch_failed,
  small_workspace = robcogen_gpu_small_workspace,
  wrong_layout = robcogen_gpu_wrong_layout
};

inline const char* message(Status status) noexcept {
  return robcogen_gpu_message(static_cast<robcogen_gpu_status>(status));
}

// A cudaStream_t or a hipStream_t; null: the default stream.
struct Stream {
  void* handle = nullptr;
  Stream() = default;
  Stream(void* stream) noexcept : handle(stream) {}
};

struct Workspace {
  void* data = nullptr;
  std::size_t bytes = 0;
  operator robcogen_gpu_workspace() const noexcept { return {data, bytes}; }
};

template <class Number>
struct Array {
  Number* data;
  robcogen_gpu_layout layout;
  std::ptrdiff_t stride;
};

template <class Number>
Array<Number> by_tile(Number* data) noexcept {
  return {data, robcogen_gpu_by_tile, 0};
}
template <class Number>
Array<Number> by_element(Number* data, std::ptrdiff_t stride) noexcept {
  return {data, robcogen_gpu_by_element, stride};
}
template <class Number>
Array<Number> by_state(Number* data, std::ptrdiff_t stride = 0) noexcept {
  return {data, robcogen_gpu_by_state, stride};
}
// Of a symmetric result, whose elements above the diagonal are not written.
template <class Number>
Array<Number> lower_by_tile(Number* data) noexcept {
  return {data, robcogen_gpu_lower_by_tile, 0};
}
// One state, the same for all.
template <class Number>
Array<const Number> same_for_all(const Number* data) noexcept {
  return {data, robcogen_gpu_same_for_all, 0};
}

template <class Number>
struct In {
  robcogen_gpu_array array;
  In(const Array<const Number>& a) noexcept : array{a.data, a.layout, a.stride} {}
  In(const Array<Number>& a) noexcept : array{a.data, a.layout, a.stride} {}
};
template <class Number>
struct Out {
  robcogen_gpu_array array;
  Out(const Array<Number>& a) noexcept : array{a.data, a.layout, a.stride} {}
};

}  // namespace robcogen::gpu
#endif

#endif
