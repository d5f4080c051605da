// The choices and passes between a model and its programs, each of which can be switched off.
#pragma once

#include <string>
#include <vector>

#include "algorithm/formulation/formulation.h"

namespace robcogen::driver {

// The step that computes congruent limbs in the lanes of vectors, in languages that have vectors. It comes last.
inline constexpr const char* kLanesStep = "lanes";

// The choices of a formulation, then the passes, then kLanesStep.
std::vector<std::string> all_steps();

// The steps that are taken, and the effort of the search for link frames: the search may trace `effort` times as many
// statements as with effort 1; 0 leaves it out.
struct Steps {
  std::vector<std::string> names = all_steps();
  int effort = 1;

  algorithm::Formulation formulation() const;
  std::vector<std::string> passes() const;
  bool has_lanes() const;
};

}  // namespace robcogen::driver
