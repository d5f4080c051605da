// Splits programs into the computation of sines and cosines and the rest, which takes them as inputs.
//
// A controller that calls many functions in one state computes sines and cosines once and passes them to all functions.
// All programs number the angles in the same way: first the position of each joint, then the sums of joint positions,
// constants and parameters that programs read as well. The addition theorems give the sines and cosines of sums from
// those of the joints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pass/angle_sums.h"
#include "symbolic/core.h"

namespace robcogen::pass {

struct SplitAngles {
  // By program; nullopt for a program that reads no sine or cosine of such angles.
  std::vector<std::optional<symbolic::Core>> cores;
  int angle_count = 0;
  symbolic::Program angles;    // [parameters,] q -> all angles
  symbolic::Program addition;  // [parameters,] sin_joint, cos_joint -> sin_q, cos_q of all angles
};

// A program, and the same program with congruent limbs in lanes, if there is one.
struct WithLanes {
  const symbolic::Program& program;
  const symbolic::Program* in_lanes = nullptr;
};

// A sine or cosine of anything other than a sum of angles, constants and parameters stays where it is. All programs
// have these positions as inputs, and the same parameters or none.
SplitAngles split_angles(const std::vector<WithLanes>& programs, const std::vector<Position>& positions);

}  // namespace robcogen::pass
