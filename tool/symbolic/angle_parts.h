// A program split at the sines and cosines that it reads.
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

struct AngleParts {
  // The program without its sines and cosines: it takes sin_q and cos_q, of all angles of its library, as inputs after
  // the joint positions.
  Program core;
  // The core with congruent limbs in lanes, if there is one.
  std::optional<Program> core_in_lanes;
  std::vector<int> read;  // the angles whose sine or cosine the cores read, in ascending order
  Program angles;         // [parameters,] q -> these angles, in this order
};

}  // namespace robcogen::symbolic
