// How the frames of loops miss one another where the positions of all joints are given: those that sensors measure, or
// those of a simulator that does not keep loops closed.
#pragma once

#include <string>

#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// Rows of the errors of a loop.
int rows_of(model::LoopType type);

// positions of all joints -> errors of all loops, one after another. Of each the position of its second frame in its
// first one (m), and of a hinge x and y of the second z axis in the first frame; of a distance its excess alone (m).
symbolic::Program loop_error(const model::KinematicTree& tree, const std::string& name);

// Its derivative by the positions of all joints.
symbolic::Program loop_jacobian(const model::KinematicTree& tree, const std::string& name);

// q, qd -> velocities of all joints, in the order of joint_positions.
symbolic::Program joint_velocities(const model::KinematicTree& tree, const std::string& name);

// q, qd, qdd -> accelerations of all joints.
symbolic::Program joint_accelerations(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
