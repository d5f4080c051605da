// Arrays over all joints, in the order of joint_positions.
#pragma once

#include <string>
#include <vector>

#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

// By joint, from an input, which has these other elements behind them. `tree`: that says which joints follow others;
// the one that is traced may be another.
std::vector<Expression> input_of_all_joints(
    Trace& trace,
    const model::KinematicTree& tree,
    const std::string& name,
    const std::vector<std::string>& others = {});
void output_of_all_joints(
    Trace& trace,
    const model::KinematicTree& tree,
    const std::string& name,
    const std::vector<Expression>& by_joint);

}  // namespace robcogen::algorithm
