// From a model to programs.
#pragma once

#include <string>
#include <vector>

#include "driver/functions.h"
#include "driver/load.h"
#include "driver/steps.h"

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

// All functions of these groups, then the derivatives that the model asks for, in the formulation of the steps, before
// any pass.
Functions trace(const Model& model, const std::vector<std::string>& groups, const Steps& steps);
// The same. For a robot with congruent limbs that are worth lanes, it also sets Function::congruent.
Functions trace_for_lanes(const Model& model, const std::vector<std::string>& groups, const Steps& steps);

}  // namespace robcogen::driver
