// Programs that read sines and cosines of joint angles, parted into the computation of these and what follows from
// them.
//
// A controller that calls many functions in one state computes sines and cosines once, and hands them to all. They are
// numbered alike for all programs: first an angle for each joint, its own position, then the sums that programs read
// beside these, of several joints, of constants and parameters. From sines and cosines of the joints alone those of
// sums follow by the addition theorems.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "symbolic/angle_parts.h"

namespace robcogen::pass {

struct SplitAngles {
  // By program; none of one that reads no sine or cosine of such angles.
  std::vector<std::optional<symbolic::AngleParts>> parts;
  int angle_count = 0;
  symbolic::Program angles;    // [parameters,] q -> all angles
  symbolic::Program addition;  // [parameters,] sin_joint, cos_joint -> sin_q, cos_q of all angles
};

// A program, and the same where equal limbs share lanes, if some do.
struct WithLanes {
  const symbolic::Program& program;
  const symbolic::Program* in_lanes = nullptr;
};

// A sine or cosine of anything else than a sum of positions, constants and parameters stays where it is. The programs
// have the same joint positions, of these joints, and the same parameters, or none.
SplitAngles split_angles(const std::vector<WithLanes>& programs, const std::vector<std::string>& joints);

}  // namespace robcogen::pass
