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

// The elements of a result for the states of one block: a kernel writes to it as to an array of values. Element k is at
// data + k * element.
template <class Scalar>
class Columns {
 public:
  using Value = NativeLanes<Scalar>;

  class Column {
   public:
    ROBCOGEN_INLINE Column(Scalar* data, std::ptrdiff_t element) noexcept : data_(data), element_(element) {}
    ROBCOGEN_INLINE const Value& operator=(const Value& x) const noexcept {
      x.store(data_);
      return x;
    }
    // The columns from this one on.
    ROBCOGEN_INLINE Columns operator&() const noexcept { return {data_, element_}; }

   private:
    Scalar* data_;
    std::ptrdiff_t element_;
  };

  ROBCOGEN_INLINE Columns(Scalar* data, std::ptrdiff_t element) noexcept : data_(data), element_(element) {}
  ROBCOGEN_INLINE Column operator[](std::ptrdiff_t k) const noexcept { return {data_ + k * element_, element_}; }

 private:
  Scalar* data_;
  std::ptrdiff_t element_;
};

// The states of one block of `count` states. In the last block, lanes without a state repeat the last one, so
// that no memory beyond it is read or written.
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
      in_fours<kElements>([&](int k, const Scalar* at) noexcept { to[k] = Value::load(at); }, data, from.element);
    } else if (kHasRows && from.element == 1) {
      load_rows<kElements>(data, from.state, to);
    } else {
      in_fours<kElements>(
          [&](int k, const Scalar* at) noexcept { to[k] = Value::gather(at, from.state); }, data, from.element);
    }
  }

  template <int kElements>
  void store(const Value* from, const Strided<Scalar>& to) const noexcept {
    Scalar* data = to.data + first_ * to.state;
    if (left() < kSize) {
      store_some(from, kElements, to);
    } else if (to.state == 1) {
      in_fours<kElements>([&](int k, Scalar* at) noexcept { from[k].store(at); }, data, to.element);
    } else if (kHasRows && to.element == 1) {
      store_rows<kElements>(from, data, to.state);
    } else {
      in_fours<kElements>([&](int k, Scalar* at) noexcept { from[k].scatter(at, to.state); }, data, to.element);
    }
  }

  // Where a kernel writes a result: to its place where the states of the block are contiguous there, else to the
  // buffer.
  Columns<Scalar> columns(const Strided<Scalar>& to, Value* buffer) const noexcept {
    if (is_in_place(to)) return {to.data + first_, to.element};
    return {reinterpret_cast<Scalar*>(buffer), kSize};
  }
  // From the buffer, if it was written there.
  template <int kElements>
  void store_buffer(const Value* buffer, const Strided<Scalar>& to) const noexcept {
    if (!is_in_place(to)) store<kElements>(buffer, to);
  }

 private:
  bool is_in_place(const Strided<Scalar>& to) const noexcept { return left() >= kSize && to.state == 1; }

  // With two lanes, single elements move as fast.
  static constexpr bool kHasRows = kSize > 2;

  // States one after another, with contiguous elements: four elements at a time are a block.
  template <int kElements>
  static void load_rows(const Scalar* data, std::ptrdiff_t state, Value* to) noexcept {
    int k = 0;
    for (; k + 4 <= kElements; k += 4) lanes::load_block<4, false>(data + k, state, to + k);
    for (; k < kElements; ++k) to[k] = Value::gather(data + k, state);
  }
  template <int kElements>
  static void store_rows(const Value* from, Scalar* data, std::ptrdiff_t state) noexcept {
    int k = 0;
    for (; k + 4 <= kElements; k += 4)
      lanes::store_block<false>(data + k, state, from[k], from[k + 1], from[k + 2], from[k + 3]);
    for (; k < kElements; ++k) from[k].scatter(data + k, state);
  }

  // move(k, pointer to element k) for each k. Four at a time are two thirds of the instructions of one at a time.
  template <int kElements, class Move, class Number>
  static void in_fours(Move move, Number* data, std::ptrdiff_t stride) noexcept {
    int k = 0;
    for (; k + 4 <= kElements; k += 4, data += 4 * stride) {
      move(k, data);
      move(k + 1, data + stride);
      move(k + 2, data + 2 * stride);
      move(k + 3, data + 3 * stride);
    }
    for (; k < kElements; ++k, data += stride) move(k, data);
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

// Numbers that all states share, in all lanes.
template <class Scalar>
void spread(const Scalar* from, int count, NativeLanes<Scalar>* to) noexcept {
  for (int i = 0; i < count; ++i) to[i] = NativeLanes<Scalar>(from[i]);
}

}  // namespace
}  // namespace robcogen::batch

namespace robcogen {
namespace {

// The same number in kCount columns, for kernels that write to them.
template <int kCount, class Scalar>
ROBCOGEN_INLINE void fill(const batch::Columns<Scalar>& to, const typename batch::Columns<Scalar>::Value& x) noexcept {
  for (int i = 0; i < kCount; ++i) to[i] = x;
}

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
