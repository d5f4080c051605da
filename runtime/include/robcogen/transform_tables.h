// Tables in a generated library of coordinate transforms: each transform as a product of primitive ones.
//
// The self-check of such libraries is written once over these tables.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "robcogen/matrix.h"
#include "robcogen/reflection.h"

namespace robcogen::reflection {

// An intermediate result of an amount, and the largest magnitude so far: the scale of rounding errors.
struct Amount {
  long double value = 0;
  long double size = 0;

  Amount() = default;
  explicit Amount(double number) : Amount(number, 0) {}
  Amount(long double result, long double met) : value(result), size(std::max(std::abs(result), met)) {}

  friend Amount operator-(const Amount& a) { return {-a.value, a.size}; }
  friend Amount operator+(const Amount& a, const Amount& b) { return {a.value + b.value, std::max(a.size, b.size)}; }
  friend Amount operator-(const Amount& a, const Amount& b) { return {a.value - b.value, std::max(a.size, b.size)}; }
  friend Amount operator*(const Amount& a, const Amount& b) { return {a.value * b.value, std::max(a.size, b.size)}; }
  friend Amount operator/(const Amount& a, const Amount& b) { return {a.value / b.value, std::max(a.size, b.size)}; }
  friend Amount sin(const Amount& a) { return {std::sin(a.value), a.size}; }
  friend Amount cos(const Amount& a) { return {std::cos(a.value), a.size}; }
  friend Amount sqrt(const Amount& a) { return {std::sqrt(a.value), a.size}; }
};

// Maps coordinates of a frame that is turned about (rotation) or moved along an axis to those of the original frame.
struct Factor {
  bool rotation;
  int axis;  // 0 x, 1 y, 2 z
};

// left_X_right in three forms, as functions of all parameters and variables of the model.
struct ProductOfFactors {
  template <int n>
  using Function = Matrix<double, n, n> (*)(const double* parameters, const double* variables) noexcept;

  const char* name;
  int left;  // frame indices
  int right;
  Table<Factor> factors;  // the first one leftmost
  void (*amounts)(const Amount* parameters, const Amount* variables, Amount* amounts) noexcept;  // of each, rad or m
  Function<4> homogeneous;
  Function<6> motion;  // angular first
  Function<6> force;   // moment first
};

struct Transforms {
  const char* name;
  int parameter_count;
  int variable_count;
  int frame_count;
  Table<ProductOfFactors> transforms;
  // Functions with derivatives; their inputs are parameters and the variables that they depend on.
  Table<Function> functions = {nullptr, 0};
  Table<Derivative> derivatives = {nullptr, 0};
};

}  // namespace robcogen::reflection
