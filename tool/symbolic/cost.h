// What programs cost. Every choice between programs compares costs by a measure from here, and all weights are here.
#pragma once

#include <cstddef>
#include <vector>

#include "symbolic/expression.h"
#include "symbolic/program.h"

namespace robcogen::symbolic {

// Latency of an addition, a multiplication or both fused, in cycles of current processors.
inline constexpr int kLatency = 4;
// Latency of extracting a lane from a vector or inserting it.
inline constexpr int kMoveLatency = 3;

// The latency of an operation, in cycles. Sines and cosines count as inputs. `width`: of the value whose lanes are
// added up, each half to the other.
constexpr int latency(Op op, int width = 1) {
  switch (op) {
    case Op::sine:
    case Op::cosine:
      return 0;
    case Op::divide:
    case Op::square_root:
      return 14;
    case Op::arc_tangent:
      return 80;
    case Op::gather:
      return kMoveLatency;
    case Op::sum_lanes:
      return width > 1 ? kMoveLatency + kLatency + latency(op, width / 2) : 0;
    default:
      return kLatency;
  }
}

// An operation on all lanes of a value counts once.
struct Cost {
  int mul = 0;
  int add = 0;  // additions and subtractions
  int div = 0;
  int sqrt = 0;
  int sincos = 0;         // distinct arguments of sin and cos, and arc tangents
  int instructions = 0;   // mul + add after fusing a product into the sum that uses it
  int moves = 0;          // instructions that move scalars into and out of lanes, and that add up lanes
  int critical_path = 0;  // cycles
};

Cost cost(const Program& program);

// What one of each adds to a measure of costs.
struct Weights {
  int operation = 0;  // a product, sum or difference
  int instruction = 0;
  int division = 0;  // or square root
  int move = 0;
};

// Programs for the same purpose are compared by their work: operations, and again what is left of them after fusing.
inline constexpr Weights kWork = {.operation = 1, .instruction = 1, .division = 8};
// Forms of one transform are compared by their instructions, equal ones by their operations.
inline constexpr Weights kOfTransforms = {.operation = 1, .instruction = 1 << 16};
// Half cycles in which a processor with two units for products and sums starts the instructions of a program.
inline constexpr Weights kStarts = {.instruction = 1, .move = 1};

constexpr int weighted(const Cost& c, const Weights& w) {
  return w.operation * (c.mul + c.add) + w.instruction * c.instructions + w.division * (c.div + c.sqrt) +
         w.move * c.moves;
}

// Predicted cycles of a call: the critical path, or the time in which all instructions start if that is more.
constexpr int time(const Cost& c) {
  const int starts = weighted(c, kStarts) / 2;
  return c.critical_path > starts ? c.critical_path : starts;
}

// Whether this predicted time is less than the other one by so much that it will not be a loss.
constexpr bool is_clearly_faster(int time, int other) {
  return 8 * time < 7 * other;
}

// The work of a program and its predicted time between two changes of the parameters: values that depend on parameters
// alone cost nothing.
int work(const Program& program);
int predicted_time(const Program& program);

// The cost of the program with these outputs, from the graph that it is traced in.
struct TracedCost {
  int work = 0;  // if it has no parameters
  long statements = 0;
  double largest_constant = 0.0;
};
TracedCost traced_cost(const Graph& graph, const std::vector<std::vector<Expression>>& outputs);

// The work of everything that was built since the mark, where the uses of these values are not known yet: each sum is
// fused with a product that it reads.
int work_since(const Graph& graph, std::size_t mark);

}  // namespace robcogen::symbolic
