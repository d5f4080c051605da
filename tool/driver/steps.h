// The choices and passes on the way from a model to its programs, each of which can be switched off.
#pragma once

#include <string>
#include <vector>

#include "algorithm/formulation/formulation.h"

namespace robcogen::driver {

// The step that computes congruent limbs in the lanes of vectors, in languages that have vectors. It comes last.
inline constexpr const char* kLanesStep = "lanes";

// The choices of a formulation, then the passes, then kLanesStep.
std::vector<std::string> all_steps();

// Those that are taken, and how hard to look for link frames: the search may trace that many times the statements of
// effort 1; 0 leaves it out.
struct Steps {
  std::vector<std::string> names = all_steps();
  int effort = 1;

  algorithm::Formulation formulation() const;
  std::vector<std::string> passes() const;
  bool has_lanes() const;
};

}  // namespace robcogen::driver
