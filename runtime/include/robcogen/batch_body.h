// Parts of generated functions over many states: one block of states at a time, one state in each lane.
#pragma once

#include <cstddef>

#include "robcogen/batch.h"
#include "robcogen/lane_blocks.h"
#include "robcogen/lanes.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE inline
#endif

namespace robcogen::batch {
namespace {  // separate in each file, like lanes

// The elements of a result for the states of one block. A kernel writes to it as to an array of values; element k is at
// data + k * element. With kRows > 0 the result is a square matrix of kRows rows, and the elements above its diagonal
// are not written.
template <class Scalar, int kRows = 0>
class Columns {
 public:
  using Value = NativeLanes<Scalar>;

  class Column {
   public:
    ROBCOGEN_INLINE Column(const Columns& columns, std::ptrdiff_t k) noexcept : columns_(columns), k_(k) {}
    // Kernels index elements by constants, so the compiler removes the comparison.
    ROBCOGEN_INLINE const Value& operator=(const Value& x) const noexcept {
      if (!is_above_diagonal(k_)) x.store(columns_.data_ + k_ * columns_.element_);
      return x;
    }

   private:
    const Columns& columns_;
    std::ptrdiff_t k_;
  };

  ROBCOGEN_INLINE Columns(Scalar* data, std::ptrdiff_t element) noexcept : data_(data), element_(element) {}
  ROBCOGEN_INLINE Column operator[](std::ptrdiff_t k) const noexcept { return {*this, k}; }

 private:
  ROBCOGEN_INLINE static constexpr bool is_above_diagonal([[maybe_unused]] std::ptrdiff_t k) noexcept {
    if constexpr (kRows == 0)
      return false;
    else
      return k % kRows < k / kRows;
  }

  Scalar* data_;
  std::ptrdiff_t element_;
};

// The current block of `count` states, one state in each lane. In the last block, lanes without a state repeat the last
// state, so that no memory beyond it is read or written.
template <class Scalar>
class Block {
 public:
  using Value = NativeLanes<Scalar>;
  static constexpr int kSize = lanes::kInRegister<Scalar>;

  explicit Block(std::ptrdiff_t count) noexcept : count_(count) {}

  bool is_left() const noexcept { return first_ < count_; }
  void advance() noexcept { first_ += kSize; }

  template <int kElements>
  void load(const Strided<const Scalar>& from, Value* to) const noexcept {
    const Scalar* data = from.data + first_ * from.state;
    if (left() < kSize) {
      load_some(from, kElements, to);
    } else if (from.state == 1) {
      in_fours([&](int k, const Scalar* at) noexcept { to[k] = Value::load(at); }, kElements, data, from.element);
    } else if (kHasRows && from.element == 1) {
      load_rows<kElements>(data, from.state, to);
    } else {
      in_fours(
          [&](int k, const Scalar* at) noexcept { to[k] = Value::gather(at, from.state); }, kElements, data,
          from.element);
    }
  }

  template <int kElements>
  void store(const Value* from, const Strided<Scalar>& to) const noexcept {
    store(from, kElements, to);
  }

  // The lower triangle of a matrix with kRows rows and columns, column by column.
  template <int kRows>
  void store_lower(const Value* from, const Strided<Scalar>& to) const noexcept {
    for (int i = 0; i < kRows; ++i) store(from + i * kRows + i, kRows - i, to.from(i * kRows + i));
  }

  // Returns where a kernel writes a result: directly to its destination `to` if the states of the block are contiguous
  // there, otherwise to the buffer.
  Columns<Scalar> columns(const Strided<Scalar>& to, Value* buffer) const noexcept {
    return in_place_or<0>(to, buffer);
  }
  // The same for a lower triangle.
  template <int kRows>
  Columns<Scalar, kRows> lower_columns(const Strided<Scalar>& to, Value* buffer) const noexcept {
    return in_place_or<kRows>(to, buffer);
  }
  // Copies the result from the buffer to `to`, if the kernel wrote it there.
  template <int kElements>
  void store_buffer(const Value* buffer, const Strided<Scalar>& to) const noexcept {
    if (!is_in_place(to)) store<kElements>(buffer, to);
  }
  template <int kRows>
  void store_lower_buffer(const Value* buffer, const Strided<Scalar>& to) const noexcept {
    if (!is_in_place(to)) store_lower<kRows>(buffer, to);
  }

 private:
  template <int kRows>
  Columns<Scalar, kRows> in_place_or(const Strided<Scalar>& to, Value* buffer) const noexcept {
    if (is_in_place(to)) return {to.data + first_, to.element};
    return {reinterpret_cast<Scalar*>(buffer), kSize};
  }

  bool is_in_place(const Strided<Scalar>& to) const noexcept { return left() >= kSize && to.state == 1; }

  // With two lanes, moving single elements is as fast.
  static constexpr bool kHasRows = kSize > 2;

  // For states whose elements are contiguous: four elements of all lanes are moved at a time, as one block.
  template <int kElements>
  static void load_rows(const Scalar* data, std::ptrdiff_t state, Value* to) noexcept {
    int k = 0;
    for (; k + 4 <= kElements; k += 4) lanes::load_block<4, false>(data + k, state, to + k);
    for (; k < kElements; ++k) to[k] = Value::gather(data + k, state);
  }
  ROBCOGEN_INLINE static void store_rows(const Value* from, int elements, Scalar* data, std::ptrdiff_t state) noexcept {
    int k = 0;
    for (; k + 4 <= elements; k += 4)
      lanes::store_block<false>(data + k, state, from[k], from[k + 1], from[k + 2], from[k + 3]);
    for (; k < elements; ++k) from[k].scatter(data + k, state);
  }

  // Calls move(k, pointer to element k) for each k. Four calls at a time take two thirds of the instructions of one.
  template <class Move, class Number>
  ROBCOGEN_INLINE static void in_fours(Move move, int elements, Number* data, std::ptrdiff_t stride) noexcept {
    int k = 0;
    for (; k + 4 <= elements; k += 4, data += 4 * stride) {
      move(k, data);
      move(k + 1, data + stride);
      move(k + 2, data + 2 * stride);
      move(k + 3, data + 3 * stride);
    }
    for (; k < elements; ++k, data += stride) move(k, data);
  }

  ROBCOGEN_INLINE void store(const Value* from, int elements, const Strided<Scalar>& to) const noexcept {
    Scalar* data = to.data + first_ * to.state;
    if (left() < kSize) {
      store_some(from, elements, to);
    } else if (to.state == 1) {
      in_fours([&](int k, Scalar* at) noexcept { from[k].store(at); }, elements, data, to.element);
    } else if (kHasRows && to.element == 1) {
      store_rows(from, elements, data, to.state);
    } else {
      in_fours([&](int k, Scalar* at) noexcept { from[k].scatter(at, to.state); }, elements, data, to.element);
    }
  }

  std::ptrdiff_t left() const noexcept { return count_ - first_; }

  void load_some(const Strided<const Scalar>& from, int elements, Value* to) const noexcept {
    for (int k = 0; k < elements; ++k) {
      Scalar numbers[kSize];
      for (int i = 0; i < kSize; ++i) {
        const std::ptrdiff_t state = i < left() ? first_ + i : count_ - 1;
        numbers[i] = from.data[k * from.element + state * from.state];
      }
      to[k] = Value::load(numbers);
    }
  }

  void store_some(const Value* from, int elements, const Strided<Scalar>& to) const noexcept {
    for (int k = 0; k < elements; ++k)
      for (int i = 0; i < left(); ++i) to.data[k * to.element + (first_ + i) * to.state] = from[k][i];
  }

  std::ptrdiff_t first_ = 0;
  std::ptrdiff_t count_;
};

// Copies numbers that all states share to all lanes.
template <class Scalar>
void spread(const Scalar* from, int count, NativeLanes<Scalar>* to) noexcept {
  for (int i = 0; i < count; ++i) to[i] = NativeLanes<Scalar>(from[i]);
}

}  // namespace
}  // namespace robcogen::batch

#undef ROBCOGEN_INLINE
