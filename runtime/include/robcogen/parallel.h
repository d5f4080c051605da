// Functions over many states on several threads.
//
//   robcogen::batch::ThreadPool pool;
//   robcogen::batch::parallel(pool, n, [](const auto&... a) { hyl::batch::gravity_forces(a...); },
//                             by_element(q, stride), by_element(tau, stride));
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "robcogen/batch.h"
#include "robcogen/thread_pool.h"

namespace robcogen::batch {

// Bytes that the arguments of one block of states may take. A core's own cache holds them, so that a function that
// makes several calls in turn finds the results of one call in the cache when it makes the next.
inline constexpr std::ptrdiff_t kBlockBytes = 256 * 1024;

namespace detail {

// The same array from state `first` on.
template <class Value, class Number>
ByElement<Value, Number> states_from(const ByElement<Value, Number>& array, std::ptrdiff_t first) noexcept {
  return {array.data + first, array.stride};
}
template <class Value, class Number>
ByState<Value, Number> states_from(const ByState<Value, Number>& array, std::ptrdiff_t first) noexcept {
  return {array.data, array.stride, array.first + first};
}
// A value that is the same in all states.
template <class T>
const T& states_from(const T& value, std::ptrdiff_t) noexcept {
  return value;
}

// Stands for an array in a call over no states, and adds the bytes of one state when it becomes an argument.
template <class Array>
class Measured {
 public:
  Measured(const Array& array, std::ptrdiff_t& bytes) noexcept : array_(array), bytes_(bytes) {}

  template <class T, class = std::enable_if_t<std::is_convertible_v<const Array&, Input<T>>>>
  operator Input<T>() const noexcept {
    bytes_ += static_cast<std::ptrdiff_t>(sizeof(T));
    return array_;
  }
  template <class T, class = std::enable_if_t<std::is_convertible_v<const Array&, Output<T>>>>
  operator Output<T>() const noexcept {
    bytes_ += static_cast<std::ptrdiff_t>(sizeof(T));
    return array_;
  }

 private:
  const Array& array_;
  std::ptrdiff_t& bytes_;
};

template <class Value, class Number>
Measured<ByElement<Value, Number>> measured(const ByElement<Value, Number>& array, std::ptrdiff_t& bytes) noexcept {
  return {array, bytes};
}
template <class Value, class Number>
Measured<ByState<Value, Number>> measured(const ByState<Value, Number>& array, std::ptrdiff_t& bytes) noexcept {
  return {array, bytes};
}
template <class T>
const T& measured(const T& value, std::ptrdiff_t&) noexcept {
  return value;
}

// Number of states in a block, with `bytes` per state. It is a multiple of 64, so that a block has whole vectors of any
// processor and whole cache lines.
constexpr std::ptrdiff_t block_size(std::ptrdiff_t bytes) noexcept {
  constexpr std::ptrdiff_t kUnit = 64, kMax = 4096;
  const std::ptrdiff_t fit = kBlockBytes / std::max<std::ptrdiff_t>(bytes, 1);
  return std::clamp(fit / kUnit * kUnit, kUnit, kMax);
}

}  // namespace detail

// Splits n states into blocks and calls function(count, arrays…) for each block. The arrays are the arguments of
// functions over many states, by_element(…) and by_state(…); any other argument is the same in all states. Results are
// those of one call, to the last bit. A first call of the function, over no states, tells how large a state is.
//
// threads(blocks, task) must call task(0), …, task(blocks - 1), each once, on any threads, and return when all have
// ended. It is a ThreadPool, or a few lines over OpenMP, TBB, std::execution or a pool of your own.
template <class Threads, class Function, class... Arrays>
void parallel(Threads&& threads, std::ptrdiff_t n, const Function& function, const Arrays&... arrays) {
  if (n <= 0) return;
  std::ptrdiff_t bytes = 0;
  function(std::ptrdiff_t{0}, detail::measured(arrays, bytes)...);
  const std::ptrdiff_t size = detail::block_size(bytes);
  threads((n + size - 1) / size, [&](std::ptrdiff_t block) {
    const std::ptrdiff_t first = block * size;
    function(std::min(size, n - first), detail::states_from(arrays, first)...);
  });
}

}  // namespace robcogen::batch
