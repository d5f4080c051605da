// Which values of a program congruent limbs compute together, one limb in each lane, and in which order.
//
// Superword packing from known seeds (after Larsen and Amarasinghe 2000): from corresponding outputs, and from
// corresponding terms of sums over the limbs, tuples of statements become one packed value each, operand by operand. A
// value that is the same for all limbs stays scalar; a value without counterpart is computed as before and gathered.
#pragma once

#include <optional>
#include <vector>

#include "pass/lanes/correspondence.h"
#include "symbolic/program.h"

namespace robcogen::pass {

// A packed value, negated in some of its lanes.
struct Part {
  int packed_value = -1;  // into LanePlan::packed_values
  unsigned negated_lanes = 0;
};

// A value with a lane for each limb.
struct PackedValue {
  enum class Kind { broadcast, numbers, gather, operation, sum };
  Kind kind = Kind::gather;
  Tuple lanes;  // the scalars that it replaces, without signs; empty for a sum that no single limb has
  int width = 0;
  int place = 0;  // the statement of the program after which it can be computed
  symbolic::Op op = symbolic::Op::add;
  std::vector<Part> parts;
};

// A mask with a bit for each lane.
constexpr unsigned all_lanes(const PackedValue& w) {
  return (1U << w.width) - 1U;
}

// A scalar sum some of whose terms come from all limbs of a class.
struct SumOfLimbs {
  std::vector<int> packed_values;
  std::vector<symbolic::Operand> rest;
};

struct LanePlan {
  struct Scalar {
    bool needed = false;
    int packed_value = -1, lane = -1;  // if it is a lane of a packed value
    std::optional<SumOfLimbs> sum;
  };
  std::vector<Scalar> scalars;  // by statement
  std::vector<PackedValue> packed_values;
  std::vector<Part> roots;  // the packed values that outputs read, with their signs there
  std::vector<int> order;   // statements, then packed values, as one list of indices; operands before users

  int scalar_count() const { return static_cast<int>(scalars.size()); }
};

// `zero`: the constant that fills up limbs with fewer operands. nullopt if values would depend on each other, or if
// the limbs have too little in common.
std::optional<LanePlan> lane_plan(
    const symbolic::Program& program,
    const std::vector<InputTuples>& classes,
    const symbolic::Operand& zero);

}  // namespace robcogen::pass
