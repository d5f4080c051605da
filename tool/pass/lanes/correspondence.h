// Which statements of a program compute the same quantity for different limbs.
#pragma once

#include <cstdint>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::pass {

inline constexpr int kMaxLanes = 8;

// Input elements that correspond, one of each limb: {qd[0], qd[3], qd[6], qd[9]}. Flat indices.
using InputTuples = std::vector<std::vector<int>>;

// One operand of each limb.
using Tuple = std::vector<symbolic::Operand>;

class Correspondence {
 public:
  // `classes`: the inputs of each class of limbs. `inner`: the sums that are part of the only sum that reads them.
  Correspondence(
      const symbolic::Program& program,
      const std::vector<InputTuples>& classes,
      const std::vector<bool>& inner);

  // The limb that a value belongs to: its class and lane; -1: none. A value that depends on all limbs of a class, such
  // as the motion of the base that carries them, belongs to none; a value that depends on it and on one limb belongs to
  // that limb.
  struct Owner {
    int limbs = -1;
    int lane = -1;
    friend bool operator==(const Owner&, const Owner&) = default;
  };
  Owner owner(const symbolic::Operand& o) const;

  // Puts corresponding operands together, given those of each limb, the most similar ones first. Operands without a
  // partner stay in `lists`.
  std::vector<Tuple> match(std::vector<std::vector<symbolic::Operand>>& lists) const;

 private:
  // How similar two operands must be. equal: the same except for limb, signs and numbers; similar: the same, but any
  // two values that belong to no limb count as equal; kind: operands of the same kind.
  enum class Likeness { equal, similar, kind };
  std::uint64_t hash(const symbolic::Operand& o, Likeness likeness) const;
  // The limbs that a value depends on, a bit for each; none if it depends on all limbs of a class.
  std::uint64_t limbs(const symbolic::Operand& o) const;
  void hash_statement(std::size_t i);

  const symbolic::Program& program_;
  const std::vector<bool>& inner_;
  std::vector<std::uint64_t> all_limbs_;  // by class
  std::vector<std::uint64_t> input_limbs_;
  std::vector<int> input_group_;  // -1: none
  std::vector<bool> input_is_number_;
  std::vector<std::uint64_t> limbs_;                        // by statement
  std::vector<std::uint64_t> equal_, similar_;              // by statement
  std::vector<std::uint64_t> equal_terms_, similar_terms_;  // of the terms of sums, in any order
};

}  // namespace robcogen::pass
