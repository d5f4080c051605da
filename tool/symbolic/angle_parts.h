// A program split at the sines and cosines that it reads.
#pragma once

#include <optional>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

struct AngleParts {
  // The program without them: it takes sin_q and cos_q, of all angles of its library, as inputs behind the joint
  // positions.
  Program core;
  // The same with congruent limbs in lanes, if the program has them.
  std::optional<Program> core_in_lanes;
  std::vector<int> read;  // the angles whose sine or cosine these read, in rising order
  Program angles;         // [parameters,] q -> these angles, in this order
};

}  // namespace robcogen::symbolic
