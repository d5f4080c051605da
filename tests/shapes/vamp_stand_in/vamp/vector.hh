// What generated headers use of the vectors of the planner VAMP: rows of numbers in registers of eight.
#pragma once

#include <array>
#include <cstddef>

namespace vamp {

using FloatT = float;
inline constexpr std::size_t FloatVectorWidth = 8;
inline constexpr std::size_t FloatVectorAlignment = 32;

template <std::size_t columns = FloatVectorWidth, std::size_t rows = 1>
struct FloatVector {
  static constexpr std::size_t registers = (columns + FloatVectorWidth - 1) / FloatVectorWidth;
  static constexpr std::size_t num_scalars_rounded = rows * registers * FloatVectorWidth;
  std::array<std::array<float, FloatVectorWidth>, rows* registers> data = {};

  FloatVector() = default;
  FloatVector(float x) {
    for (auto& part : data) part.fill(x);
  }
  explicit FloatVector(const std::array<float, columns * rows>& numbers) {
    for (std::size_t i = 0; i < columns; ++i) data[i / FloatVectorWidth][i % FloatVectorWidth] = numbers[i];
  }

  FloatVector<columns>& operator[](std::size_t row) { return reinterpret_cast<FloatVector<columns>&>(data[row]); }

  template <class F>
  FloatVector each(const FloatVector& other, F f) const {
    FloatVector result;
    for (std::size_t i = 0; i < data.size(); ++i)
      for (std::size_t k = 0; k < FloatVectorWidth; ++k) result.data[i][k] = f(data[i][k], other.data[i][k]);
    return result;
  }
  friend FloatVector operator+(const FloatVector& a, const FloatVector& b) {
    return a.each(b, [](float x, float y) { return x + y; });
  }
  friend FloatVector operator-(const FloatVector& a, const FloatVector& b) {
    return a.each(b, [](float x, float y) { return x - y; });
  }
  friend FloatVector operator*(const FloatVector& a, const FloatVector& b) {
    return a.each(b, [](float x, float y) { return x * y; });
  }
};

}  // namespace vamp
