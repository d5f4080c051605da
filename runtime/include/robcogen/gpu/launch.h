// Starts kernels over many states, after checks of their arguments: included by the units of generated libraries. As
// C++ for the host, without CUDA and HIP, the units compute all states in the call.
#pragma once

#include <cstdint>
#include <limits>

#include "robcogen/gpu/batch.h"
#include "robcogen/gpu/dialect.h"

namespace robcogen::gpu {

// An argument, the number of elements of one of its states, and whether kernels write it.
struct Argument {
  robcogen_gpu_array array;
  int size;
  bool is_output = false;
};

constexpr std::ptrdiff_t kMaxElements = std::numeric_limits<int>::max();

inline robcogen_gpu_status check(std::ptrdiff_t n, const Argument& a, std::size_t alignment) noexcept {
  const auto& [data, layout, stride] = a.array;
  if (a.size == 0) return robcogen_gpu_success;
  // In C, a layout may be any number.
  const int number = layout;
  if (number < robcogen_gpu_by_tile || number > robcogen_gpu_lower_by_tile) return robcogen_gpu_wrong_layout;
  if (layout == robcogen_gpu_same_for_all && a.is_output) return robcogen_gpu_wrong_layout;
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
template <class Number, int kRows>
bool is_taken(const Argument& a, const LowerTiles<Number, kRows>*) noexcept {
  return a.array.layout == robcogen_gpu_lower_by_tile;
}
template <class Number>
bool is_taken(const Argument& a, const Strides<Number>*) noexcept {
  return a.array.layout != robcogen_gpu_lower_by_tile;
}

template <class Number>
void take(const Argument& a, Tiles<Number>& states) noexcept {
  states = {static_cast<Number*>(const_cast<void*>(a.array.data))};
}
template <class Number, int kRows>
void take(const Argument& a, LowerTiles<Number, kRows>& states) noexcept {
  states = {static_cast<Number*>(const_cast<void*>(a.array.data))};
}
template <class Number>
void take(const Argument& a, Strides<Number>& states) noexcept {
  const auto& [data, layout, stride] = a.array;
  states.data = static_cast<Number*>(const_cast<void*>(data));
  const int given = static_cast<int>(stride);
  switch (layout) {
    case robcogen_gpu_by_tile:
    case robcogen_gpu_lower_by_tile:
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

// Where and how a kernel runs: for each state `runs` threads in different blocks, or `lanes` neighbouring ones.
struct Launch {
  void* stream;
  int n;
  unsigned runs = 1;
  unsigned lanes = 1;
};

template <class... States>
robcogen_gpu_status run(void (*kernel)(int, States...), Launch launch, States... states) noexcept {
#if defined(__CUDACC__) || defined(__HIP__)
  void* pointers[] = {&launch.n, &states...};
  const dim3 blocks((static_cast<unsigned>(launch.n) * launch.lanes + 127) / 128, launch.runs), threads(128);
  const void* const code = reinterpret_cast<const void*>(kernel);
#endif
#if defined(__CUDACC__)
  const cudaError_t error =
      cudaLaunchKernel(code, blocks, threads, pointers, 0, static_cast<cudaStream_t>(launch.stream));
  if (error == cudaErrorNoKernelImageForDevice || error == cudaErrorInvalidDeviceFunction)
    return robcogen_gpu_no_device_code;
  return error == cudaSuccess ? robcogen_gpu_success : robcogen_gpu_launch_failed;
#elif defined(__HIP__)
  const hipError_t error = hipLaunchKernel(code, blocks, threads, pointers, 0, static_cast<hipStream_t>(launch.stream));
  if (error == hipErrorNoBinaryForGpu || error == hipErrorInvalidDeviceFunction) return robcogen_gpu_no_device_code;
  return error == hipSuccess ? robcogen_gpu_success : robcogen_gpu_launch_failed;
#elif defined(ROBCOGEN_GPU_EMULATES_LANES)
  emulate(launch.lanes, [&] { kernel(launch.n, states...); });
  return robcogen_gpu_success;
#else
  kernel(launch.n, states...);
  return robcogen_gpu_success;
#endif
}

template <std::size_t kCount, class... States>
robcogen_gpu_status take_and_run(
    const Launch& launch,
    const Argument (&arguments)[kCount],
    void (*kernel)(int, States...)) noexcept {
  const Argument* next = arguments;
  const auto taken = [&](auto states) {
    take(*next++, states);
    return states;
  };
  struct Call {
    robcogen_gpu_status status;
    Call(void (*k)(int, States...), const Launch& l, States... states) : status(run(k, l, states...)) {}
  };
  // Braces evaluate the arguments from left to right.
  return Call{kernel, launch, taken(States{})...}.status;
}

template <std::size_t kCount>
robcogen_gpu_status check(std::ptrdiff_t n, const Argument (&arguments)[kCount], std::size_t alignment) noexcept {
  if (n < 0) return robcogen_gpu_negative_count;
  if (n == 0) return robcogen_gpu_success;
  if (n > kMaxElements - 2 * kTile) return robcogen_gpu_too_large;
  for (const Argument& a : arguments)
    if (const robcogen_gpu_status bad = check(n, a, alignment); bad != robcogen_gpu_success) return bad;
  return robcogen_gpu_success;
}

// Starts the first of the kernels that takes all arguments.
template <std::size_t kCount>
robcogen_gpu_status start(const Launch&, const Argument (&)[kCount]) noexcept {
  return robcogen_gpu_wrong_layout;
}
template <std::size_t kCount, class... States, class... Others>
robcogen_gpu_status start(
    const Launch& launch,
    const Argument (&arguments)[kCount],
    void (*kernel)(int, States...),
    Others... others) noexcept {
  static_assert(sizeof...(States) == kCount);
  const Argument* next = arguments;
  const bool are_taken[] = {is_taken(*next++, static_cast<const States*>(nullptr))...};
  for (const bool is_taken : are_taken)
    if (!is_taken) return start(launch, arguments, others...);
  return take_and_run(launch, arguments, kernel);
}

// The same for a function that is one kernel: over tiles, with strides, or between them over other tiles.
template <std::size_t kCount, class First, class... States, class... Others>
robcogen_gpu_status start(
    void* stream,
    std::ptrdiff_t n,
    const Argument (&arguments)[kCount],
    void (*kernel)(int, First, States...),
    Others... others) noexcept {
  const robcogen_gpu_status checked = check(n, arguments, alignof(decltype(*First::data)));
  if (checked != robcogen_gpu_success || n == 0) return checked;
  return start(Launch{stream, static_cast<int>(n)}, arguments, kernel, others...);
}

// Fewer states than this are computed in lanes, where a function has lanes: they would not fill a GPU with a thread
// each. By count of instructions and warps, not measured.
#if !defined(ROBCOGEN_GPU_STATES_IN_LANES)
#define ROBCOGEN_GPU_STATES_IN_LANES 8192
#endif

// Starts the first of the kernels in lanes that takes all arguments; not for many states or wrong arguments.
template <unsigned kLanes, std::size_t kCount, class First, class... States, class... Others>
bool is_started_in_lanes(
    void* stream,
    std::ptrdiff_t n,
    const Argument (&arguments)[kCount],
    robcogen_gpu_status& status,
    void (*kernel)(int, First, States...),
    Others... others) noexcept {
  if (n <= 0 || n >= ROBCOGEN_GPU_STATES_IN_LANES || n > kMaxElements / kLanes) return false;
  if (check(n, arguments, alignof(decltype(*First::data))) != robcogen_gpu_success) return false;
  status = start(Launch{stream, static_cast<int>(n), 1, kLanes}, arguments, kernel, others...);
  return status != robcogen_gpu_wrong_layout;
}
#define ROBCOGEN_GPU_TRY_LANES(lanes, ...) \
  robcogen_gpu_status status;              \
  if (is_started_in_lanes<lanes>(stream, n, arguments, status, __VA_ARGS__)) return status

// The kernels of a function, one after the other, until one does not start.
template <class Number, std::size_t kCount>
class Stages {
 public:
  // `size`: the elements of one state in the workspace.
  Stages(
      void* stream,
      std::ptrdiff_t n,
      const Argument (&arguments)[kCount],
      const robcogen_gpu_workspace& workspace,
      int size) noexcept
      : launch_{stream, static_cast<int>(n)}, status_(check(n, arguments, alignof(Number))) {
    for (std::size_t k = 0; k < kCount; ++k) arguments_[k] = arguments[k];
    arguments_[kCount] = {{workspace.data, robcogen_gpu_by_tile, 0}, size, true};
    if (status_ != robcogen_gpu_success || n == 0) return;
    // Before the first kernel starts, because a later one would refuse it.
    for (const Argument& a : arguments)
      if (a.array.layout == robcogen_gpu_lower_by_tile) status_ = robcogen_gpu_wrong_layout;
    if (status_ != robcogen_gpu_success) return;
    const robcogen_gpu_status fits = check(n, arguments_[kCount], alignof(Number));
    if (fits == robcogen_gpu_too_large)
      status_ = fits;
    else if (
        fits != robcogen_gpu_success ||
        workspace.bytes < robcogen_gpu_workspace_bytes(n, static_cast<std::size_t>(size), sizeof(Number)))
      status_ = robcogen_gpu_small_workspace;
  }

  // `which`: the arguments that the kernel takes; the workspace follows the last one.
  template <std::size_t... which, class Tiled, class Strided>
  void run(unsigned runs, Tiled* over_tiles, Strided* with_strides) noexcept {
    if (status_ != robcogen_gpu_success || launch_.n == 0) return;
    const Argument taken[] = {arguments_[which]...};
    status_ = start(Launch{launch_.stream, launch_.n, runs, 1}, taken, over_tiles, with_strides);
  }

  robcogen_gpu_status status() const noexcept { return status_; }

 private:
  Launch launch_;
  robcogen_gpu_status status_;
  Argument arguments_[kCount + 1] = {};
};

}  // namespace robcogen::gpu
