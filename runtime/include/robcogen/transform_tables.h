// Tables in a generated library of coordinate transforms: each transform as a product of primitive ones.
//
// The self-check of such libraries is written once over these tables.
#pragma once

#include <Eigen/Core>

#include "robcogen/reflection.h"

namespace robcogen::reflection {

// A step of the computation of an amount, in postfix order: operands come before their operator.
struct AmountStep {
  enum Kind {
    constant,
    parameter,
    variable,
    negate,
    add,
    subtract,
    multiply,
    divide,
    sine,
    cosine,
    tangent,
    square_root,
  };
  Kind kind;
  double value;  // constant
  int index;     // parameter, variable
};

// Coordinates of a frame turned about (rotation), or moved along, an axis to those of the original frame.
struct Factor {
  bool rotation;
  int axis;                  // 0 x, 1 y, 2 z
  Table<AmountStep> amount;  // rad or m
};

// left_X_right in three forms, as functions of all parameters and variables of the model.
struct ProductOfFactors {
  template <int n>
  using Function = Eigen::Matrix<double, n, n> (*)(const double* parameters, const double* variables) noexcept;

  const char* name;
  int left;  // frame indices
  int right;
  Table<Factor> factors;  // the first one leftmost
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
};

}  // namespace robcogen::reflection
