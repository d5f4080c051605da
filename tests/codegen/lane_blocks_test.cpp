// Compares blocks of lanes with single elements.
#include "robcogen/lane_blocks.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "lane_shapes.h"

namespace robcogen {
namespace {

constexpr int kUntouched = -1;  // the value of memory outside the block

template <class Shape>
class LaneBlocksOf : public testing::Test {};

TYPED_TEST_SUITE(LaneBlocksOf, LaneShapes);

// Lane i of value k; all of them are different.
template <class Scalar>
Scalar number(int k, int i) {
  return static_cast<Scalar>(100 * k + i);
}

template <class Scalar, int kSize>
Lanes<Scalar, kSize> value(int k) {
  Scalar numbers[kSize];
  for (int i = 0; i < kSize; ++i) numbers[i] = number<Scalar>(k, i);
  return Lanes<Scalar, kSize>::load(numbers);
}

// The block in memory, written element by element, with a margin on both sides.
template <class Scalar>
std::vector<Scalar> memory(int count, int stride, int size) {
  std::vector<Scalar> elements(static_cast<std::size_t>(stride * size + 2 * count), Scalar(kUntouched));
  for (int i = 0; i < size; ++i)
    for (int k = 0; k < count; ++k) elements[static_cast<std::size_t>(count + i * stride + k)] = number<Scalar>(k, i);
  return elements;
}

// There are hundreds of shapes: code that they share is compiled only once.
template <class Scalar>
void expect_equal(const std::vector<Scalar>& found, const std::vector<Scalar>& expected, int count, int stride) {
  EXPECT_EQ(found, expected) << count << " values, distance " << stride;
}

template <class Scalar, int kSize, int kStride, int... kValue>
void expect_block(std::integer_sequence<int, kValue...>) {
  constexpr int kCount = sizeof...(kValue);
  const std::vector<Scalar> expected = memory<Scalar>(kCount, kStride, kSize);
  std::vector<Scalar> found(expected.size(), Scalar(kUntouched));
  store_lanes<kStride>(found.data() + kCount, value<Scalar, kSize>(kValue)...);
  expect_equal(found, expected, kCount, kStride);

  const auto loaded = load_lanes<kSize, kCount, kStride>(expected.data() + kCount);
  std::vector<Scalar> elements, numbers;
  for (int k = 0; k < kCount; ++k) {
    for (int i = 0; i < kSize; ++i) {
      elements.push_back(loaded[static_cast<std::size_t>(k)][i]);
      numbers.push_back(number<Scalar>(k, i));
    }
  }
  expect_equal(elements, numbers, kCount, kStride);
}

template <class Scalar, int kSize, int... kLess>
void expect_blocks(std::integer_sequence<int, kLess...>) {
  (expect_block<Scalar, kSize, kLess + 1>(std::make_integer_sequence<int, kLess + 1>()), ...);
  (expect_block<Scalar, kSize, kLess + 2>(std::make_integer_sequence<int, kLess + 1>()), ...);
  (expect_block<Scalar, kSize, 18>(std::make_integer_sequence<int, kLess + 1>()), ...);
}

TYPED_TEST(LaneBlocksOf, AreStoredAndLoadedAsSingleElements) {
  expect_blocks<typename TypeParam::Scalar, TypeParam::kSize>(std::make_integer_sequence<int, 9>());
}

template <class Scalar, int kCount>
void expect_filled() {
  std::vector<Scalar> expected(kCount + 2, Scalar(kUntouched)), found = expected;
  for (int i = 1; i <= kCount; ++i) expected[static_cast<std::size_t>(i)] = Scalar(0.5);
  fill<kCount>(found.data() + 1, Scalar(0.5));
  expect_equal(found, expected, kCount, 0);
}

template <class Scalar, int... kLess>
void expect_all_filled(std::integer_sequence<int, kLess...>) {
  (expect_filled<Scalar, kLess + 1>(), ...);
}

TYPED_TEST(LaneBlocksOf, FillNoMoreThanTheyAreTold) {
  expect_all_filled<typename TypeParam::Scalar>(std::make_integer_sequence<int, 35>());
}

}  // namespace
}  // namespace robcogen
