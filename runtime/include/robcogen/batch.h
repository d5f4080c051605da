// Arguments of functions over many states: arrays with an explicit layout.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "robcogen/level.h"

// Whether functions over many states are compiled for several processors, with a choice when the program runs.
#define ROBCOGEN_BATCH_LEVELS ROBCOGEN_HAS_LEVELS

namespace Eigen {
template <class Derived>
struct EigenBase;
}

namespace robcogen::batch {

using robcogen::available;
using robcogen::best_level;
using robcogen::Level;

inline constexpr bool kHasLevels = ROBCOGEN_BATCH_LEVELS != 0;

// Which elements of a symmetric matrix are written. `lower` writes the diagonal and the elements below it, and leaves
// those above it unchanged.
enum class Storage { full, lower };

// Element k of state i is at data[k * element + i * state].
template <class Number>
struct Strided {
  Number* data;
  std::ptrdiff_t element;
  std::ptrdiff_t state;

  // The same states without their first k elements.
  // Kernels for newer processors call it: a function of its own would be shared with code for all.
  [[gnu::always_inline]] constexpr Strided from(std::ptrdiff_t k) const noexcept {
    return {data + k * element, element, state};
  }
};

// Value type of an array of plain numbers for which the caller names no type.
struct AnyVector {};

// Structure of arrays: element k of state i is at data[k * stride + i]. Fastest: states are loaded without shuffles.
template <class Value, class Number>
struct ByElement {
  Number* data;
  std::ptrdiff_t stride;
};

// Array of structures: element k of state i is at data[(first + i) * stride + k].
template <class Value, class Number>
struct ByState {
  Number* data;
  std::ptrdiff_t stride;  // 0: states are contiguous
  std::ptrdiff_t first = 0;
};

// `stride` is at least the number of states. Fastest are data that are aligned to 64 bytes and a stride that is a
// multiple of 64 but not of 4096 bytes: with the latter, the elements of a state compete for the same cache set.
template <class Value = AnyVector, class Number>
ByElement<Value, Number> by_element(Number* data, std::ptrdiff_t stride) noexcept {
  static_assert(std::is_floating_point_v<Number>, "numbers, element by element");
  return {data, stride};
}

namespace detail {

template <class T, bool kIsNumber = std::is_floating_point_v<T>>
struct NumberOf {
  using type = T;
};
template <class T>
struct NumberOf<T, false> {
  using type = std::remove_cv_t<std::remove_pointer_t<decltype(std::declval<const T&>().data())>>;
};

// Types that plain numbers may stand for: Eigen's vectors and matrices, and single numbers. Twists, gravity and similar
// types are named in the call: by_state<Twist>(…).
template <class T>
constexpr bool kIsPlain = std::is_floating_point_v<T> || std::is_base_of_v<Eigen::EigenBase<T>, T>;

template <class Value, class T>
constexpr bool kFits = std::is_same_v<Value, T> || (std::is_same_v<Value, AnyVector> && kIsPlain<T>);

// Whether an argument of type T accepts an array of numbers of type From whose value type is Value.
template <class T, class Value, class Number, class From>
constexpr bool kTakes = kFits<Value, T>&& std::is_same_v<std::remove_const_t<From>, Number>;

// The array with its strides, for values of type T.
template <class T, class Value, class Number>
constexpr Strided<Number> strided(const ByElement<Value, Number>& states) noexcept {
  return {states.data, states.stride, 1};
}
template <class T, class Value, class Number>
constexpr Strided<Number> strided(const ByState<Value, Number>& states) noexcept {
  constexpr std::ptrdiff_t kElements = sizeof(T) / sizeof(typename NumberOf<T>::type);
  const std::ptrdiff_t stride = states.stride != 0 ? states.stride : kElements;
  return {states.data + states.first * stride, 1, stride};
}

}  // namespace detail

// `stride` is at least the number of elements of a state; without it, states are contiguous.
template <class Value = AnyVector, class Number, class = std::enable_if_t<std::is_floating_point_v<Number>>>
ByState<Value, Number> by_state(Number* data, std::ptrdiff_t stride = 0) noexcept {
  return {data, stride};
}

// An array of Eigen vectors, of twists, …
template <class T, class = std::enable_if_t<!std::is_floating_point_v<T>>>
auto by_state(T* states) noexcept {
  using Value = std::remove_const_t<T>;
  using Plain = typename detail::NumberOf<Value>::type;
  using Number = std::conditional_t<std::is_const_v<T>, const Plain, Plain>;
  static_assert(sizeof(Value) % sizeof(Number) == 0 && std::is_standard_layout_v<Value>, "numbers without gaps");
  return ByState<Value, Number>{reinterpret_cast<Number*>(states), 0};
}

// An argument of a function over many states: one T per state.
template <class T>
class Input {
 public:
  using Number = typename detail::NumberOf<T>::type;

  template <class Value, class From, class = std::enable_if_t<detail::kTakes<T, Value, Number, From>>>
  Input(const ByElement<Value, From>& states) noexcept : array_(constant(detail::strided<T>(states))) {}
  template <class Value, class From, class = std::enable_if_t<detail::kTakes<T, Value, Number, From>>>
  Input(const ByState<Value, From>& states) noexcept : array_(constant(detail::strided<T>(states))) {}
  // One value for all states. It must live as long as the call.
  Input(const T& value) noexcept : array_{reinterpret_cast<const Number*>(&value), 1, 0} {}

  const Strided<const Number>& array() const noexcept { return array_; }

 private:
  template <class From>
  static Strided<const Number> constant(const Strided<From>& a) noexcept {
    return {a.data, a.element, a.state};
  }

  Strided<const Number> array_;
};

// A result of a function over many states: one T per state. It must not overlap an argument.
template <class T>
class Output {
 public:
  using Number = typename detail::NumberOf<T>::type;

  template <class Value, class = std::enable_if_t<detail::kFits<Value, T>>>
  Output(const ByElement<Value, Number>& states) noexcept : array_(detail::strided<T>(states)) {}
  template <class Value, class = std::enable_if_t<detail::kFits<Value, T>>>
  Output(const ByState<Value, Number>& states) noexcept : array_(detail::strided<T>(states)) {}

  const Strided<Number>& array() const noexcept { return array_; }

 private:
  Strided<Number> array_;
};

}  // namespace robcogen::batch
