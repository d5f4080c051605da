// Parts of generated functions over many states that compute one state after the other: those whose results are so
// large that blocks of states would overflow the stacks of threads, and all on machines for which the library has no
// blocks.
#pragma once

#include <cstddef>

#include "robcogen/batch.h"

namespace robcogen::batch {
namespace {  // separate in each file, like lanes

template <class Scalar>
class States {
 public:
  explicit States(std::ptrdiff_t count) noexcept : count_(count) {}

  bool is_left() const noexcept { return state_ < count_; }
  void advance() noexcept { ++state_; }

  // Returns the elements of an argument: in the caller's memory if they are contiguous there, otherwise copied to the
  // buffer.
  template <int kElements>
  const Scalar* load(const Strided<const Scalar>& from, Scalar* buffer) const noexcept {
    const Scalar* data = from.data + state_ * from.state;
    if (from.element == 1) return data;
    for (int k = 0; k < kElements; ++k) buffer[k] = data[k * from.element];
    return buffer;
  }

  // Returns where a kernel writes a result: directly to its destination `to` if its elements are contiguous there,
  // otherwise to the buffer.
  Scalar* place(const Strided<Scalar>& to, Scalar* buffer) const noexcept {
    return to.element == 1 ? to.data + state_ * to.state : buffer;
  }
  // Copies the result from the buffer to `to`, if the kernel wrote it there.
  template <int kElements>
  void store_buffer(const Scalar* buffer, const Strided<Scalar>& to) const noexcept {
    if (to.element == 1) return;
    Scalar* data = to.data + state_ * to.state;
    for (int k = 0; k < kElements; ++k) data[k * to.element] = buffer[k];
  }
  // Copies the lower triangle of a matrix with kRows rows and columns.
  template <int kRows>
  void store_lower(const Scalar* buffer, const Strided<Scalar>& to) const noexcept {
    Scalar* data = to.data + state_ * to.state;
    for (int column = 0; column < kRows; ++column)
      for (int k = column * kRows + column; k < (column + 1) * kRows; ++k) data[k * to.element] = buffer[k];
  }

 private:
  std::ptrdiff_t state_ = 0;
  std::ptrdiff_t count_;
};

}  // namespace
}  // namespace robcogen::batch
