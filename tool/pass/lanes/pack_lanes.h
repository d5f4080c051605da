// Congruent limbs in the lanes of vectors: one statement computes a quantity for all limbs of a class.
#pragma once

#include <optional>
#include <vector>

#include "pass/lanes/correspondence.h"
#include "symbolic/program.h"

namespace robcogen::pass {

struct Packed {
  symbolic::Program program;
  std::vector<bool> in_lanes;  // which of the classes share lanes
};

// The program with its constants as plain numbers, which fold as themselves, each once.
symbolic::Program with_plain_numbers(const symbolic::Program& program);

// Whether the program reads inputs of two limbs of one class, so that lanes could compute both at once.
bool reads_congruent_limbs(const symbolic::Program& program, const std::vector<InputTuples>& classes);

// The program with lanes for those classes of limbs that make it clearly faster (symbolic::predicted_time) than `time`;
// nullopt if no class does, or if it has lanes already. Each class has 2, 4 or 8 limbs.
std::optional<Packed> pack_lanes_within(
    const symbolic::Program& program,
    const std::vector<InputTuples>& classes,
    int time);

// The same compared with the program itself, which is the result if no class makes it clearly faster.
//
// `congruent` computes the same with limbs that fold in the same way, at the price of products with zeros and ones. It
// replaces the program if lanes make it faster.
Packed pack_lanes(
    const symbolic::Program& program,
    const std::vector<InputTuples>& classes,
    const std::optional<symbolic::Program>& congruent = std::nullopt);

// All classes that can be packed, whatever that costs; a program that has lanes stays as it is.
symbolic::Program packed(const symbolic::Program& program, const std::vector<InputTuples>& classes);

}  // namespace robcogen::pass
