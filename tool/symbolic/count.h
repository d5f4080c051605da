// Operation count and critical path of a program: cost measures without noise.
#pragma once

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Latencies on current processors, in cycles: of an addition, a multiplication or both fused; of a division or square
// root; of an arc tangent.
inline constexpr int kLatency = 4;
inline constexpr int kDivisionLatency = 14;
inline constexpr int kArcTangentLatency = 80;
// Latency of extracting a lane from a vector or inserting it, in cycles.
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

// Predicted cycles of a call on a processor with two units for products and sums: the critical path, or half the
// instructions and moves if that is more. Values that depend on parameters alone cost nothing.
int predicted_time(const Program& program);

// The cost by which programs for the same purpose are compared: operations plus instructions after fusing. Values that
// depend on parameters alone cost nothing.
int work(const Program& program);

}  // namespace robcogen::symbolic
