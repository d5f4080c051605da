// Inverse kinematics in closed form, for chains that have one (inverse/plan.h).
#pragma once

#include <string>
#include <vector>

#include "model/inverse_task.h"
#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// The sizes of the functions; zeros if the chain has no closed form.
struct InverseKinematicsSize {
  int joints = 0;  // of the chain, without a given one
  int branches = 0;
  int signs = 0;
};
InverseKinematicsSize inverse_kinematics_size(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task);

// All branches: sines and cosines of the joints, by joint and branch.
symbolic::Program inverse_kinematics(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task,
    const std::string& name);

// The positions in the branch with these signs.
symbolic::Program inverse_kinematics_branch(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task,
    const std::string& name);

// The signs of the branch in which these positions are.
symbolic::Program inverse_kinematics_configuration(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task,
    const std::string& name);

// A line for what is special about the axes, and one for each step; or why there is no closed form.
std::vector<std::string> inverse_kinematics_steps(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task);

}  // namespace robcogen::algorithm
