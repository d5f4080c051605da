// Loads and stores of several values with lanes at once: adjacent numbers are moved as vectors, and shuffles put them
// into their lanes or take them out.
//
// A block has one element for each value and each lane: value k of lane i is at [i * stride + k]. The joint forces of
// limbs, or columns of a matrix, limb by limb, are blocks.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "robcogen/lanes.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE inline
#endif

namespace robcogen {
namespace {  // separate in each file, like lanes
namespace lanes {

template <class Scalar, int kSize>
using Two = std::array<Lanes<Scalar, kSize>, 2>;
template <class Scalar, int kSize>
using Three = std::array<Lanes<Scalar, kSize>, 3>;
template <class Scalar, int kSize>
using Four = std::array<Lanes<Scalar, kSize>, 4>;

// Alternating lanes of a and b: for doubles the even lanes (a0 b0 a2 b2) and the odd ones, for floats the first two
// (a0 b0 a1 b1) and the last two. The processor has one instruction for each result.
template <class Scalar>
ROBCOGEN_INLINE Two<Scalar, 4> zipped(const Lanes<Scalar, 4>& a, const Lanes<Scalar, 4>& b) noexcept {
  if constexpr (sizeof(Scalar) == 8)
    return {shuffled<0, 4, 2, 6>(a, b), shuffled<1, 5, 3, 7>(a, b)};
  else
    return {shuffled<0, 4, 1, 5>(a, b), shuffled<2, 6, 3, 7>(a, b)};
}
template <class Scalar>
ROBCOGEN_INLINE Two<Scalar, 2> zipped(const Lanes<Scalar, 2>& a, const Lanes<Scalar, 2>& b) noexcept {
  return {shuffled<0, 2>(a, b), shuffled<1, 3>(a, b)};
}

// Result i has lane i of a, b, c and d.
template <class Scalar>
ROBCOGEN_INLINE Four<Scalar, 4> transposed(
    const Lanes<Scalar, 4>& a,
    const Lanes<Scalar, 4>& b,
    const Lanes<Scalar, 4>& c,
    const Lanes<Scalar, 4>& d) noexcept {
  const Two<Scalar, 4> ab = zipped(a, b), cd = zipped(c, d);
  if constexpr (sizeof(Scalar) == 8)
    return {
        shuffled<0, 1, 4, 5>(ab[0], cd[0]), shuffled<0, 1, 4, 5>(ab[1], cd[1]), shuffled<2, 3, 6, 7>(ab[0], cd[0]),
        shuffled<2, 3, 6, 7>(ab[1], cd[1])};
  else
    return {
        shuffled<0, 1, 4, 5>(ab[0], cd[0]), shuffled<2, 3, 6, 7>(ab[0], cd[0]), shuffled<0, 1, 4, 5>(ab[1], cd[1]),
        shuffled<2, 3, 6, 7>(ab[1], cd[1])};
}

// Interleaves to a0 b0 c0 a1, b1 c1 a2 b2, c2 a3 b3 c3; `taken_apart` is the inverse.
template <class Scalar>
ROBCOGEN_INLINE Three<Scalar, 4> interleaved(
    const Lanes<Scalar, 4>& a,
    const Lanes<Scalar, 4>& b,
    const Lanes<Scalar, 4>& c) noexcept {
  const Lanes<Scalar, 4> ab = shuffled<0, 4, 2, 6>(a, b), ca = shuffled<0, 5, 2, 7>(c, a),
                         bc = shuffled<1, 5, 3, 7>(b, c);
  return {shuffled<0, 1, 4, 5>(ab, ca), shuffled<0, 1, 6, 7>(bc, ab), shuffled<2, 3, 6, 7>(ca, bc)};
}
template <class Scalar>
ROBCOGEN_INLINE Three<Scalar, 4> taken_apart(
    const Lanes<Scalar, 4>& x,
    const Lanes<Scalar, 4>& y,
    const Lanes<Scalar, 4>& z) noexcept {
  const Lanes<Scalar, 4> ab = shuffled<0, 1, 6, 7>(x, y), ca = shuffled<2, 3, 4, 5>(x, z),
                         bc = shuffled<0, 1, 6, 7>(y, z);
  return {shuffled<0, 5, 2, 7>(ab, ca), shuffled<1, 4, 3, 6>(ab, bc), shuffled<0, 5, 2, 7>(ca, bc)};
}

// Whether a value has more lanes than the functions above take, so that it is stored and loaded half by half.
template <class Scalar, int kSize>
constexpr bool kHasHalves = kSize > 1 && (kSize > kInRegister<Scalar> || kSize > 4);

template <class Scalar>
ROBCOGEN_INLINE void store_pair(Scalar* to, std::ptrdiff_t stride, const Two<Scalar, 4>& zipped) noexcept {
  constexpr int kSecond = sizeof(Scalar) == 8 ? 2 : 1;  // the lane in the second half of zipped[0]
  half<0>(zipped[0]).store(to);
  half<1>(zipped[0]).store(to + kSecond * stride);
  half<0>(zipped[1]).store(to + (3 - kSecond) * stride);
  half<1>(zipped[1]).store(to + 3 * stride);
}

template <class Scalar>
ROBCOGEN_INLINE void store_pair(Scalar* to, std::ptrdiff_t stride, const Two<Scalar, 2>& zipped) noexcept {
  zipped[0].store(to);
  zipped[1].store(to + stride);
}

// kIsDense: the stride is the number of values.
template <bool kIsDense, class Scalar, class Column>
ROBCOGEN_INLINE void store_block(Scalar* to, std::ptrdiff_t stride, const Column& a) noexcept {
  a.scatter(to, stride);
}

template <bool kIsDense, class Scalar, int kSize, class... More>
ROBCOGEN_INLINE void store_block(
    Scalar* to,
    std::ptrdiff_t stride,
    const Lanes<Scalar, kSize>& a,
    const Lanes<Scalar, kSize>& b,
    const More&... more) noexcept;

template <class Scalar, class... More>
ROBCOGEN_INLINE void store_fours(
    Scalar* to,
    std::ptrdiff_t stride,
    const Lanes<Scalar, 4>& a,
    const Lanes<Scalar, 4>& b,
    const Lanes<Scalar, 4>& c,
    const Lanes<Scalar, 4>& d,
    const More&... more) noexcept {
  const Four<Scalar, 4> rows = transposed(a, b, c, d);
  rows[0].store(to);
  rows[1].store(to + stride);
  rows[2].store(to + 2 * stride);
  rows[3].store(to + 3 * stride);
  if constexpr (sizeof...(More) > 0) store_block<false>(to + 4, stride, more...);
}

template <bool kIsDense, class Scalar, int kSize, class... More>
ROBCOGEN_INLINE void store_block(
    Scalar* to,
    std::ptrdiff_t stride,
    const Lanes<Scalar, kSize>& a,
    const Lanes<Scalar, kSize>& b,
    const More&... more) noexcept {
  if constexpr (kSize == 1) {
    to[0] = a[0];
    store_block<false>(to + 1, stride, b, more...);
  } else if constexpr (kHasHalves<Scalar, kSize>) {
    store_block<kIsDense>(to, stride, half<0>(a), half<0>(b), half<0>(more)...);
    store_block<kIsDense>(to + kSize / 2 * stride, stride, half<1>(a), half<1>(b), half<1>(more)...);
  } else if constexpr (kSize == 4 && sizeof...(More) >= 2) {
    store_fours(to, stride, a, b, more...);
  } else if constexpr (kSize == 4 && sizeof...(More) == 1 && kIsDense) {
    const Three<Scalar, 4> rows = interleaved(a, b, more...);
    rows[0].store(to);
    rows[1].store(to + 4);
    rows[2].store(to + 8);
  } else {
    store_pair(to, stride, zipped(a, b));
    if constexpr (sizeof...(More) > 0) store_block<false>(to + 2, stride, more...);
  }
}

template <std::size_t kCount, class Scalar, int kSize>
ROBCOGEN_INLINE void join(
    const Lanes<Scalar, kSize / 2>* low,
    const Lanes<Scalar, kSize / 2>* high,
    Lanes<Scalar, kSize>* columns) noexcept {
  if constexpr (kSize <= kInRegister<Scalar>)
    *columns = joined(*low, *high);
  else
    *columns = {*low, *high};
  if constexpr (kCount > 1) join<kCount - 1>(low + 1, high + 1, columns + 1);
}

// The reverse of store_block, to columns[0], …, columns[kCount - 1].
template <std::size_t kCount, bool kIsDense, class Scalar, int kSize>
ROBCOGEN_INLINE void load_block(const Scalar* from, std::ptrdiff_t stride, Lanes<Scalar, kSize>* columns) noexcept {
  using Column = Lanes<Scalar, kSize>;
  if constexpr (kCount == 1) {
    *columns = Column::gather(from, stride);
  } else if constexpr (kHasHalves<Scalar, kSize>) {
    std::array<Lanes<Scalar, kSize / 2>, kCount> low, high;
    load_block<kCount, kIsDense>(from, stride, low.data());
    load_block<kCount, kIsDense>(from + kSize / 2 * stride, stride, high.data());
    join<kCount>(low.data(), high.data(), columns);
  } else if constexpr (kCount == 3 && kIsDense && kSize == 4) {
    const Three<Scalar, 4> loaded = taken_apart(Column::load(from), Column::load(from + 4), Column::load(from + 8));
    columns[0] = loaded[0];
    columns[1] = loaded[1];
    columns[2] = loaded[2];
  } else if constexpr (kCount >= 4 && kSize == 4) {
    const Four<Scalar, 4> loaded = transposed(
        Column::load(from), Column::load(from + stride), Column::load(from + 2 * stride),
        Column::load(from + 3 * stride));
    columns[0] = loaded[0];
    columns[1] = loaded[1];
    columns[2] = loaded[2];
    columns[3] = loaded[3];
    if constexpr (kCount > 4) load_block<kCount - 4, false>(from + 4, stride, columns + 4);
  } else if constexpr (kSize == 2) {
    const Two<Scalar, 2> loaded = zipped(Column::load(from), Column::load(from + stride));
    columns[0] = loaded[0];
    columns[1] = loaded[1];
    if constexpr (kCount > 2) load_block<kCount - 2, false>(from + 2, stride, columns + 2);
  } else {
    *columns = Column::gather(from, stride);
    load_block<kCount - 1, false>(from + 1, stride, columns + 1);
  }
}

template <class Scalar, int kSize, int... kVector>
ROBCOGEN_INLINE void store_each(
    Scalar* to,
    const Lanes<Scalar, kSize>& x,
    std::integer_sequence<int, kVector...>) noexcept {
  (x.store(to + kVector * kSize), ...);
}

}  // namespace lanes

// Writes these values as a block. With a stride equal to their number, the lanes are contiguous.
template <std::ptrdiff_t kStride, class Scalar, int kSize, class... More>
ROBCOGEN_INLINE void store_lanes(Scalar* to, const Lanes<Scalar, kSize>& first, const More&... more) noexcept {
  lanes::store_block<kStride == 1 + sizeof...(More)>(to, kStride, first, more...);
}

// Returns the kCount values of a block.
template <int kSize, std::size_t kCount, std::ptrdiff_t kStride, class Scalar>
ROBCOGEN_INLINE std::array<Lanes<Scalar, kSize>, kCount> load_lanes(const Scalar* from) noexcept {
  std::array<Lanes<Scalar, kSize>, kCount> columns;
  lanes::load_block<kCount, kStride == static_cast<std::ptrdiff_t>(kCount)>(from, kStride, columns.data());
  return columns;
}

// Writes the same number to kCount adjacent elements, as vectors; the last one may overlap the one before.
template <int kCount, class Scalar>
ROBCOGEN_INLINE void fill(Scalar* to, const Scalar& x) noexcept {
  constexpr int kSize = lanes::kInRegister<Scalar>;
  if constexpr (kCount < kSize) {
    for (int i = 0; i < kCount; ++i) to[i] = x;
  } else {
    const NativeLanes<Scalar> all(x);
    lanes::store_each(to, all, std::make_integer_sequence<int, kCount / kSize>());
    if constexpr (kCount % kSize != 0) all.store(to + kCount - kSize);
  }
}

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
