// The core of a function: its program without sines and cosines, which it takes as inputs.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// Whether the sines and cosines of these angles, in ascending order, are computed together with those of all angles
// between them: a few unused ones do no harm.
inline bool are_together(const std::vector<int>& angles) {
  return !angles.empty() && angles.back() - angles.front() < 2 * static_cast<int>(angles.size());
}

struct Core {
  Program program;                  // takes sin_q and cos_q, of all angles of its library, after the joint positions
  std::optional<Program> in_lanes;  // the same with congruent limbs in lanes, if there is one
  std::vector<int> read;            // the angles whose sine or cosine these read, in ascending order
  Program angles;                   // [parameters,] q -> these angles, in this order
};

}  // namespace robcogen::symbolic
