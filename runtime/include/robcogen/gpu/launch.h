// Starts kernels over many states, after checks of their arguments: included by the units of generated libraries. As
// C++ for the host, without CUDA and HIP, the units compute all states in the call.
#pragma once

#include <cstdint>
#include <limits>

#include "robcogen/gpu/batch.h"
#include "robcogen/gpu/dialect.h"

namespace robcogen::gpu {

// An argument, and the number of elements of one of its states.
struct Argument {
  robcogen_gpu_array array;
  int size;
};

constexpr std::ptrdiff_t kMaxElements = std::numeric_limits<int>::max();

inline robcogen_gpu_status check(std::ptrdiff_t n, const Argument& a, std::size_t alignment) noexcept {
  const auto& [data, layout, stride] = a.array;
  if (a.size == 0) return robcogen_gpu_success;
  if (data == nullptr || reinterpret_cast<std::uintptr_t>(data) % alignment != 0) return robcogen_gpu_misaligned;
  if (layout == robcogen_gpu_same_for_all) return robcogen_gpu_success;
  const bool is_by_element = layout == robcogen_gpu_by_element, is_by_state = layout == robcogen_gpu_by_state;
  if (is_by_element ? stride < n : is_by_state && stride != 0 && stride < a.size) return robcogen_gpu_wrong_stride;
  const std::ptrdiff_t whole = (n / kTile + 1) * kTile;  // at least n
  const std::ptrdiff_t count = is_by_element ? a.size : whole;
  const std::ptrdiff_t each = is_by_element || (is_by_state && stride != 0) ? stride : a.size;
  return each > kMaxElements / count ? robcogen_gpu_too_large : robcogen_gpu_success;
}

// The array as the kernel takes it; `is_taken` says whether a kernel over tiles can.
template <class Number>
bool is_taken(const Argument& a, const Tiles<Number>*) noexcept {
  return a.array.layout == robcogen_gpu_by_tile;
}
template <class Number>
bool is_taken(const Argument&, const Strides<Number>*) noexcept {
  return true;
}

template <class Number>
void take(const Argument& a, Tiles<Number>& states) noexcept {
  states = {static_cast<Number*>(const_cast<void*>(a.array.data))};
}
template <class Number>
void take(const Argument& a, Strides<Number>& states) noexcept {
  const auto& [data, layout, stride] = a.array;
  states.data = static_cast<Number*>(const_cast<void*>(data));
  const int given = static_cast<int>(stride);
  switch (layout) {
    case robcogen_gpu_by_tile:
      states.strides = {5, kTile * a.size, kTile};
      break;
    case robcogen_gpu_by_element:
      states.strides = {0, 1, given};
      break;
    case robcogen_gpu_by_state:
      states.strides = {0, given != 0 ? given : a.size, 1};
      break;
    case robcogen_gpu_same_for_all:
      states.strides = {0, 0, 1};
      break;
  }
}

template <class... States>
robcogen_gpu_status run(void (*kernel)(int, States...), void* stream, int n, States... states) noexcept {
#if defined(__CUDACC__)
  void* pointers[] = {&n, &states...};
  const unsigned blocks = (static_cast<unsigned>(n) + 127) / 128;
  const cudaError_t error = cudaLaunchKernel(
      reinterpret_cast<const void*>(kernel), dim3(blocks), dim3(128), pointers, 0, static_cast<cudaStream_t>(stream));
  if (error == cudaErrorNoKernelImageForDevice || error == cudaErrorInvalidDeviceFunction)
    return robcogen_gpu_no_device_code;
  return error == cudaSuccess ? robcogen_gpu_success : robcogen_gpu_launch_failed;
#elif defined(__HIP__)
  void* pointers[] = {&n, &states...};
  const unsigned blocks = (static_cast<unsigned>(n) + 127) / 128;
  const hipError_t error = hipLaunchKernel(
      reinterpret_cast<const void*>(kernel), dim3(blocks), dim3(128), pointers, 0, static_cast<hipStream_t>(stream));
  if (error == hipErrorNoBinaryForGpu || error == hipErrorInvalidDeviceFunction) return robcogen_gpu_no_device_code;
  return error == hipSuccess ? robcogen_gpu_success : robcogen_gpu_launch_failed;
#else
  (void)stream;
  kernel(n, states...);
  return robcogen_gpu_success;
#endif
}

template <std::size_t kCount, class... States>
robcogen_gpu_status take_and_run(
    void* stream,
    int n,
    const Argument (&arguments)[kCount],
    void (*kernel)(int, States...)) noexcept {
  const Argument* next = arguments;
  const auto taken = [&](auto states) {
    take(*next++, states);
    return states;
  };
  struct Call {
    robcogen_gpu_status status;
    Call(void (*k)(int, States...), void* s, int count, States... states) : status(run(k, s, count, states...)) {}
  };
  // Braces evaluate the arguments from left to right.
  return Call{kernel, stream, n, taken(States{})...}.status;
}

// Starts the kernel over tiles if it takes all arguments, otherwise that with strides.
template <std::size_t kCount, class... Tiled, class... Strided>
robcogen_gpu_status start(
    void* stream,
    std::ptrdiff_t n,
    const Argument (&arguments)[kCount],
    void (*over_tiles)(int, Tiled...),
    void (*with_strides)(int, Strided...)) noexcept {
  static_assert(sizeof...(Tiled) == kCount && sizeof...(Strided) == kCount);
  if (n < 0) return robcogen_gpu_negative_count;
  if (n == 0) return robcogen_gpu_success;
  if (n > kMaxElements - 2 * kTile) return robcogen_gpu_too_large;
  const std::size_t alignments[] = {alignof(decltype(*Tiled::data))...};
  const Argument* next = arguments;
  const bool are_tiles[] = {is_taken(*next++, static_cast<const Tiled*>(nullptr))...};
  bool are_taken = true;
  for (std::size_t k = 0; k < kCount; ++k) {
    are_taken = are_taken && are_tiles[k];
    if (const robcogen_gpu_status bad = check(n, arguments[k], alignments[k]); bad != robcogen_gpu_success) return bad;
  }
  const int count = static_cast<int>(n);
  return are_taken ? take_and_run(stream, count, arguments, over_tiles)
                   : take_and_run(stream, count, arguments, with_strides);
}

}  // namespace robcogen::gpu
