// How the frames of loops miss one another where the positions of all joints are given: those that sensors measure, or
// those of a simulator that does not keep loops closed.
#pragma once

#include <string>

#include "model/kinematic_tree.h"
#include "symbolic/derivative.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// q -> q with joints that follow where loops close, by Newton's method from where they are; not numbers where it does
// not reach that. Of robots with loops that no formulas close.
symbolic::Program close_loops(const model::KinematicTree& tree, const std::string& name);

// q -> the rates of tree.followers_in_q(), a row each, by those of the coordinates; nullopt where there are none.
symbolic::FollowerRates follower_rates(const model::KinematicTree& tree);

// Rows of the errors of a loop.
int rows_of(model::LoopType type);

// positions of all joints -> errors of all loops, one after another. Of each the position of its second frame in its
// first one (m; of a slider x and y alone), of a hinge x and y of the second z axis in the first frame, of a slider and
// a weld the sine of the angle between the frames along its axis; of a distance its excess alone (m).
symbolic::Program loop_error(const model::KinematicTree& tree, const std::string& name);

// Its derivative by the positions of all joints.
symbolic::Program loop_jacobian(const model::KinematicTree& tree, const std::string& name);

// q, qd -> velocities of all joints, in the order of joint_positions.
symbolic::Program joint_velocities(const model::KinematicTree& tree, const std::string& name);

// q, qd, qdd -> accelerations of all joints.
symbolic::Program joint_accelerations(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
