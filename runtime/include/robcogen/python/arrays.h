// Arguments and results of the functions of a Python module as arrays of numbers: the buffer protocol, and nested
// sequences. Only the limited API of Python is used, version 3.11.
#pragma once

#ifndef Py_LIMITED_API
#define Py_LIMITED_API 0x030b0000
#endif
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace robcogen::python {

// A constant array of the tables of a module.
template <class T>
struct List {
  const T* items = nullptr;
  std::size_t count = 0;

  constexpr List() = default;
  template <std::size_t N>
  constexpr List(const T (&array)[N]) : items(array), count(N) {}  // NOLINT(google-explicit-constructor)
  constexpr std::size_t size() const { return count; }
  constexpr bool empty() const { return count == 0; }
  constexpr const T* begin() const { return items; }
  constexpr const T* end() const { return items + count; }
  constexpr const T& operator[](std::size_t i) const { return items[i]; }
};

// An array that a function reads or writes for one state.
struct Argument {
  const char* name;
  int rank;  // 0: a number, 1: a vector of `rows` elements, 2: a matrix, 3: `pages` matrices, the last dimension
  int rows;
  int columns;
  bool is_by_rows;  // how the library stores a matrix; otherwise by columns
  bool is_parameters;
  int pages = 1;
  List<int> quaternions = {};  // the elements that begin unit quaternions
};

inline std::ptrdiff_t size(const Argument& a) {
  return static_cast<std::ptrdiff_t>(a.rows) * a.columns * a.pages;
}

// The length of a dimension.
inline int length(const Argument& a, int dimension) {
  return dimension == 0 ? a.rows : dimension == 1 ? a.columns : a.pages;
}

// `(3,)`, `(N, 3)`
inline std::string shape(const Argument& a, const std::string& first = "") {
  std::vector<std::string> lengths;
  if (!first.empty()) lengths.push_back(first);
  for (int d = 0; d < a.rank; ++d) lengths.push_back(std::to_string(length(a, d)));
  std::string text = "(";
  for (std::size_t i = 0; i < lengths.size(); ++i) text += (i ? ", " : "") + lengths[i];
  return text + (lengths.size() == 1 ? ",)" : ")");
}

// A Python array, or the numbers of a sequence, as states of an argument.
class View {
 public:
  View() = default;
  View(const View&) = delete;
  View& operator=(const View&) = delete;
  ~View() {
    if (has_buffer_) PyBuffer_Release(&buffer_);
  }

  // Both return whether they succeeded; otherwise an exception is set, whose message names `function`.
  bool read(PyObject* object, const Argument& argument, const char* function);
  bool read_result(PyObject* object, const Argument& argument, const char* function);
  // Sets the numbers of an argument that are the same in all states.
  void set_constant(const double* numbers, const Argument& argument);
  // Sets states that lie one after another, each dimension by dimension without gaps; type: 'd' or 'f'.
  void set_memory(void* data, char type, std::ptrdiff_t states, const Argument& argument);

  bool is_batch() const { return is_batch_; }
  std::ptrdiff_t states() const { return states_; }
  bool is_array() const { return has_buffer_; }
  bool is_float() const { return type_ == 'f'; }
  bool overlaps(const View& other) const { return low_ < other.high_ && other.low_ < high_; }
  // Whether elements share memory, as those of broadcast arrays do.
  bool overlaps_itself() const;

  // Copy the elements of one state, in the order of the library.
  template <class Scalar>
  void gather(std::ptrdiff_t state, Scalar* to) const {
    const char* from = data_ + state * state_stride_;
    if (type_ == 'f') {
      each<float>(from, [&](const char* at, std::ptrdiff_t k) { to[k] = static_cast<Scalar>(load<float>(at)); });
    } else {
      each<double>(from, [&](const char* at, std::ptrdiff_t k) { to[k] = static_cast<Scalar>(load<double>(at)); });
    }
  }
  template <class Scalar>
  void scatter(std::ptrdiff_t state, const Scalar* from) {
    char* const to = const_cast<char*>(data_) + state * state_stride_;
    if (type_ == 'f') {
      each<float>(to, [&](const char* at, std::ptrdiff_t k) { store(static_cast<float>(from[k]), at); });
    } else {
      each<double>(to, [&](const char* at, std::ptrdiff_t k) { store(static_cast<double>(from[k]), at); });
    }
  }

  // The same for `count` states, one after another.
  template <class Scalar>
  void gather(std::ptrdiff_t first, std::ptrdiff_t count, Scalar* to) const {
    for (std::ptrdiff_t i = 0; i < count; ++i) gather(first + i, to + i * inner_ * outer_ * pages_);
  }
  template <class Scalar>
  void scatter(std::ptrdiff_t first, std::ptrdiff_t count, const Scalar* from) {
    for (std::ptrdiff_t i = 0; i < count; ++i) scatter(first + i, from + i * inner_ * outer_ * pages_);
  }

  // Returns the first element of a state if the library can read or write the state in place, otherwise nullptr.
  template <class Scalar>
  Scalar* in_place(std::ptrdiff_t state) const {
    if (!is_dense<Scalar>()) return nullptr;
    return reinterpret_cast<Scalar*>(const_cast<char*>(data_ + state * state_stride_));
  }
  // Returns whether functions over many states can read or write the array in place, and the strides of elements and
  // states, in elements.
  template <class Scalar>
  bool strides(std::ptrdiff_t& element, std::ptrdiff_t& state) const {
    constexpr auto kSize = static_cast<std::ptrdiff_t>(sizeof(Scalar));
    if (!is_type<Scalar>() || !is_aligned<Scalar>() || !is_line_) return false;
    if (line_stride_ % kSize != 0 || state_stride_ % kSize != 0) return false;
    element = line_stride_ / kSize;
    state = state_stride_ / kSize;
    return true;
  }
  template <class Scalar>
  Scalar* first() const {
    return reinterpret_cast<Scalar*>(const_cast<char*>(data_));
  }
  // Makes a single state stand for all states of the other arguments.
  void broadcast() {
    if (states_ == 1) state_stride_ = 0;
  }

 private:
  Py_buffer buffer_{};
  bool has_buffer_ = false;
  std::vector<double> numbers_;
  const char* data_ = nullptr;
  char type_ = 'd';
  bool is_batch_ = false;
  std::ptrdiff_t states_ = 1, state_stride_ = 0;
  // In the order of the library: `inner` numbers with one stride, `outer` times, and all that `page` times.
  std::ptrdiff_t inner_ = 1, outer_ = 1, inner_stride_ = 0, outer_stride_ = 0, line_stride_ = 0;
  std::ptrdiff_t pages_ = 1, page_stride_ = 0;
  bool is_line_ = true;  // all elements of a state have one stride
  std::uintptr_t low_ = 0, high_ = 0;

  template <class T>
  static T load(const char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
  }
  template <class T>
  static void store(T value, const char* at) {
    std::memcpy(const_cast<char*>(at), &value, sizeof value);
  }
  template <class Scalar>
  bool is_type() const {
    return type_ == (sizeof(Scalar) == 4 ? 'f' : 'd');
  }
  template <class Scalar>
  bool is_aligned() const {
    return reinterpret_cast<std::uintptr_t>(data_) % alignof(Scalar) == 0;
  }
  template <class Scalar>
  bool is_dense() const {
    constexpr auto kSize = static_cast<std::ptrdiff_t>(sizeof(Scalar));
    return is_type<Scalar>() && is_line_ && (line_stride_ == kSize || inner_ * outer_ * pages_ <= 1) &&
           is_aligned<Scalar>() && state_stride_ % kSize == 0;
  }
  // Members are read once, because the compiler must assume that f changes them.
  template <class T, class F>
  void each(const char* from, F f) const {
    const std::ptrdiff_t outer = outer_, inner = inner_, outer_stride = outer_stride_, inner_stride = inner_stride_;
    const std::ptrdiff_t pages = pages_, page_stride = page_stride_;
    std::ptrdiff_t k = 0;
    for (std::ptrdiff_t p = 0; p < pages; ++p, from += page_stride) {
      const char* line = from;
      for (std::ptrdiff_t o = 0; o < outer; ++o, line += outer_stride) {
        const char* at = line;
        for (std::ptrdiff_t i = 0; i < inner; ++i, at += inner_stride) f(at, k++);
      }
    }
  }

  // The strides of the dimensions, in bytes.
  void set_strides(const Argument& a, std::ptrdiff_t row, std::ptrdiff_t column, std::ptrdiff_t page) {
    const bool is_matrix = a.rank >= 2;
    inner_ = !is_matrix ? size(a) : a.is_by_rows ? a.columns : a.rows;
    outer_ = !is_matrix ? 1 : a.is_by_rows ? a.rows : a.columns;
    pages_ = a.pages;
    inner_stride_ = is_matrix && a.is_by_rows ? column : row;
    outer_stride_ = is_matrix && a.is_by_rows ? row : column;
    page_stride_ = page;
    is_line_ = outer_ <= 1 || inner_ <= 1 || outer_stride_ == inner_ * inner_stride_;
    line_stride_ = inner_ > 1 ? inner_stride_ : outer_stride_;
    if (pages_ <= 1) return;
    if (inner_ * outer_ <= 1) line_stride_ = page_stride_;
    is_line_ = is_line_ && page_stride_ == inner_ * outer_ * line_stride_;
  }
  // The strides of numbers of this many bytes that lie dimension by dimension, the last one without gaps.
  void set_dense_strides(const Argument& a, std::ptrdiff_t bytes = 8) {
    const std::ptrdiff_t last = bytes * a.pages;
    set_strides(a, a.rank >= 2 ? last * a.columns : last, last, bytes);
  }
  bool take_buffer(const Argument& argument, const char* function, bool is_result);
  bool fail(const Argument& a, const char* function, int count, const Py_ssize_t* lengths, bool is_result) const;
  void find_range();
};

inline constexpr const char* kNotNumbers = " must be numbers, an array of float64 or float32 or a sequence";

// Appends the leaves of nested sequences to `numbers` and the lengths of the levels to `lengths`. Returns whether it
// succeeded; otherwise an exception is set.
inline bool flatten(
    PyObject* object,
    const Argument& argument,
    const char* function,
    std::size_t level,
    std::vector<Py_ssize_t>& lengths,
    std::vector<double>& numbers) {
  const auto refuse = [&](const std::string& what) {
    PyErr_SetString(PyExc_ValueError, (std::string(function) + ": " + argument.name + " " + what).c_str());
    return false;
  };
  const bool is_text = PyUnicode_Check(object) || PyBytes_Check(object) || PyComplex_Check(object);
  if (is_text || !PySequence_Check(object) || PySequence_Size(object) < 0) {
    PyErr_Clear();
    const double value = is_text ? -1.0 : PyFloat_AsDouble(object);
    if (is_text || (value == -1.0 && PyErr_Occurred())) {
      PyErr_Clear();
      return refuse(kNotNumbers + 1);
    }
    if (level < lengths.size()) return refuse("mixes numbers and sequences");
    numbers.push_back(value);
    return true;
  }
  const Py_ssize_t length = PySequence_Size(object);
  if (level == 3) return refuse("has too many dimensions");
  if (lengths.size() == level) {
    if (!numbers.empty()) return refuse("mixes numbers and sequences");
    lengths.push_back(length);
  } else if (lengths[level] != length) {
    return refuse(
        "has sequences of different lengths: " + std::to_string(lengths[level]) + " and " + std::to_string(length));
  }
  for (Py_ssize_t i = 0; i < length; ++i) {
    PyObject* const item = PySequence_GetItem(object, i);
    if (!item) return false;
    const bool is_good = flatten(item, argument, function, level + 1, lengths, numbers);
    Py_DecRef(item);
    if (!is_good) return false;
  }
  return true;
}

inline bool View::fail(const Argument& a, const char* function, int count, const Py_ssize_t* lengths, bool is_result)
    const {
  std::string given = "(";
  for (int i = 0; i < count; ++i) given += (i ? ", " : "") + std::to_string(lengths[i]);
  given += count == 1 ? ",)" : ")";
  const std::string expected = shape(a) + " or " + shape(a, "N");
  PyErr_SetString(
      PyExc_ValueError, (std::string(function) + ": " + (is_result ? "out for " : "") + a.name +
                         " must have the shape " + expected + ", has " + given)
                            .c_str());
  return false;
}

inline bool View::take_buffer(const Argument& a, const char* function, bool is_result) {
  const int expected = a.rank, lead = buffer_.ndim - expected;
  bool fits = lead == 0 || lead == 1;
  for (int d = 0; fits && d < expected; ++d) fits = buffer_.shape[lead + d] == length(a, d);
  if (!fits) return fail(a, function, buffer_.ndim, buffer_.shape, is_result);
  data_ = static_cast<const char*>(buffer_.buf);
  is_batch_ = lead == 1;
  states_ = is_batch_ ? buffer_.shape[0] : 1;
  state_stride_ = is_batch_ ? buffer_.strides[0] : 0;
  const auto stride = [&](int d) { return expected > d ? buffer_.strides[lead + d] : 0; };
  set_strides(a, stride(0), stride(1), stride(2));
  find_range();
  return true;
}

// Finds the range of addresses from the first byte to the last.
inline void View::find_range() {
  std::ptrdiff_t low = 0, high = 0;
  const auto extend = [&](std::ptrdiff_t count, std::ptrdiff_t stride) {
    if (count > 1) (stride < 0 ? low : high) += (count - 1) * stride;
  };
  extend(states_, state_stride_);
  extend(inner_, inner_stride_);
  extend(outer_, outer_stride_);
  extend(pages_, page_stride_);
  if (states_ * inner_ * outer_ * pages_ == 0) return;
  low_ = reinterpret_cast<std::uintptr_t>(data_) + static_cast<std::uintptr_t>(low);
  high_ = reinterpret_cast<std::uintptr_t>(data_) + static_cast<std::uintptr_t>(high) + (type_ == 'f' ? 4 : 8);
}

inline bool View::overlaps_itself() const {
  std::array<std::pair<std::ptrdiff_t, std::ptrdiff_t>, 4> dimensions = {// distance and count
                                                                         {{std::abs(state_stride_), states_},
                                                                          {std::abs(inner_stride_), inner_},
                                                                          {std::abs(outer_stride_), outer_},
                                                                          {std::abs(page_stride_), pages_}}};
  std::sort(dimensions.begin(), dimensions.end());
  std::ptrdiff_t reach = type_ == 'f' ? 4 : 8;
  for (const auto& [distance, count] : dimensions) {
    if (count <= 1) continue;
    if (distance < reach) return true;
    reach += (count - 1) * distance;
  }
  return false;
}

// The type of numbers that a buffer holds: 'd', 'f', or 0 for any other.
inline char type_of(const Py_buffer& buffer) {
  const char* format = buffer.format ? buffer.format : "B";
  if (*format == '@' || *format == '=' || *format == (PY_LITTLE_ENDIAN ? '<' : '>')) ++format;
  return (*format == 'd' || *format == 'f') && format[1] == 0 ? *format : '\0';
}

inline bool View::read(PyObject* object, const Argument& a, const char* function) {
  if (PyObject_CheckBuffer(object) && !PyBytes_Check(object)) {
    if (PyObject_GetBuffer(object, &buffer_, PyBUF_RECORDS_RO) == 0) {
      has_buffer_ = true;
      type_ = type_of(buffer_);
      if (type_ != 0) return take_buffer(a, function, false);
      const bool is_complex = buffer_.format && std::strchr(buffer_.format, 'Z');
      PyBuffer_Release(&buffer_);
      has_buffer_ = false;
      type_ = 'd';
      if (is_complex) {
        PyErr_SetString(PyExc_ValueError, (std::string(function) + ": " + a.name + kNotNumbers).c_str());
        return false;
      }
    } else {
      PyErr_Clear();
    }
  }
  std::vector<Py_ssize_t> lengths;
  if (!flatten(object, a, function, 0, lengths, numbers_)) return false;
  const auto expected = static_cast<std::size_t>(a.rank);
  const std::size_t lead = lengths.size() - expected;
  bool fits = lengths.size() == expected || lengths.size() == expected + 1;
  // The levels below an empty sequence are unknown.
  const bool is_empty = !lengths.empty() && lengths.back() == 0 && lengths.size() == 1;
  if (is_empty && expected > 0 && a.rows > 0) {
    is_batch_ = true;
    states_ = 0;
    set_dense_strides(a);
    return true;
  }
  for (std::size_t d = 0; fits && d < expected; ++d) fits = lengths[lead + d] == length(a, static_cast<int>(d));
  if (!fits) return fail(a, function, static_cast<int>(lengths.size()), lengths.data(), false);
  is_batch_ = lead == 1;
  states_ = is_batch_ ? lengths[0] : 1;
  data_ = reinterpret_cast<const char*>(numbers_.data());
  state_stride_ = is_batch_ ? 8 * size(a) : 0;
  set_dense_strides(a);
  return true;
}

inline bool View::read_result(PyObject* object, const Argument& a, const char* function) {
  const auto refuse = [&](const std::string& what) {
    PyErr_Clear();
    PyErr_SetString(PyExc_ValueError, (std::string(function) + ": out for " + a.name + " " + what).c_str());
    return false;
  };
  if (!PyObject_CheckBuffer(object)) return refuse("must be an array of float64 or float32");
  if (PyObject_GetBuffer(object, &buffer_, PyBUF_RECORDS) != 0) return refuse("must be a writable array");
  has_buffer_ = true;
  type_ = type_of(buffer_);
  if (type_ == 0) return refuse("must be an array of float64 or float32");
  return take_buffer(a, function, true);
}

inline void View::set_constant(const double* numbers, const Argument& a) {
  numbers_.assign(numbers, numbers + size(a));
  data_ = reinterpret_cast<const char*>(numbers_.data());
  set_dense_strides(a);
}

inline void View::set_memory(void* data, char type, std::ptrdiff_t states, const Argument& a) {
  const std::ptrdiff_t bytes = type == 'f' ? 4 : 8;
  data_ = static_cast<const char*>(data);
  type_ = type;
  is_batch_ = true;
  states_ = states;
  state_stride_ = bytes * size(a);
  set_dense_strides(a, bytes);
}

}  // namespace robcogen::python
