// Limits of joints, for the constants of generated models. No function of generated code computes with them.
#pragma once

#include <limits>

namespace robcogen {

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// Positions in rad or m, velocity in rad/s or m/s, effort in N m or N; infinite where the model has no limit.
struct JointLimits {
  double lower = -kUnlimited;
  double upper = kUnlimited;
  double velocity = kUnlimited;
  double effort = kUnlimited;
};

}  // namespace robcogen
