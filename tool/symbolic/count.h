// Operation count and critical path of a program: figures without noise.
#pragma once

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Cycles of an addition, a multiplication or the two fused, and of a division or square root, on present processors.
inline constexpr int kLatency = 4;
inline constexpr int kDivisionLatency = 14;
inline constexpr int kArcTangentLatency = 80;
// Of taking a lane out of a vector or putting it in.
inline constexpr int kMoveLatency = 3;

// An operation on all lanes of a value counts once.
struct OperationCount {
  int mul = 0;
  int add = 0;  // additions and subtractions
  int div = 0;
  int sqrt = 0;
  int sincos = 0;         // distinct arguments of sin and cos
  int instructions = 0;   // mul + add after fusing a product into the sum that uses it
  int moves = 0;          // instructions that move scalars into and out of lanes, and that add up lanes
  int critical_path = 0;  // cycles: 4 for mul, add and fused, 14 for div and sqrt, 0 for sin and cos
};

OperationCount count(const Program& program);

// Cycles between two changes of the parameters, on a processor with two units for products and sums: no less than the
// critical path, no less than half the instructions.
int predicted_time(const Program& program);

// The measure that programs of one purpose are compared by: operations plus instructions after fusing. Values that
// depend on parameters alone cost nothing.
int work(const Program& program);

}  // namespace robcogen::symbolic
