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
  int joints = 0;  // of the chain
  int branches = 0;
  int signs = 0;
  bool has_determinant = false;  // the output `determinant` is that of the Jacobian
  int newton_steps = 0;          // behind the closed form of a nominal chain
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

// The swivel angle, if the task takes it.
symbolic::Program inverse_kinematics_redundancy(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task,
    const std::string& name);

// How each joint is found, in this order: `J4: distance of the point of J1, J2, J3 and the point of J5, J6, 2 roots`;
// then the Newton steps, if the chain has a tolerance.
std::vector<std::string> inverse_kinematics_steps(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task);

// In words: what is special about the axes of a chain that has a closed form, or why it has none, and what to do.
struct InverseKinematicsReport {
  bool has_closed_form = false;
  std::string reason, hint;
};
InverseKinematicsReport report_inverse_kinematics(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task);

}  // namespace robcogen::algorithm
