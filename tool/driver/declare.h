// From a model to the functions of its library, before any is traced.
#pragma once

#include <string>
#include <vector>

#include "driver/functions.h"
#include "driver/load.h"

namespace robcogen::driver {

// The only group of functions in a library without a robot.
inline constexpr const char* kTransformsGroup = "transforms";

// A larger robot has no use for straight-line programs: its inertia matrix alone has a million elements. Documents can
// be checked and printed whatever their size.
inline constexpr int kMaxJoints = 1000;

// A warning if the robot has more than kMaxJoints, for commands that trace nothing.
void mention_joint_limit(const Model& model, Diagnostics& diagnostics);
// Throws a Failure if the robot has more than kMaxJoints.
void require_traceable(const Model& model);

// All functions of these groups, then the derivatives that the model asks for. Those of transforms are traced: there is
// nothing to choose. Throws a Failure if a derivative is of no function or input.
Functions declare(const Model& model, const std::vector<std::string>& groups);

}  // namespace robcogen::driver
