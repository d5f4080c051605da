// Arrays over all joints, in the order of joint_positions.
#pragma once

#include <string>
#include <vector>

#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

// An input of all joints, returned by joint and followed by these other elements. `tree` says which joints follow
// others; the tree that is traced may be a different one.
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
