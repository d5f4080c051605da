// Functions of loops, such as the distance of their frames when the positions of all joints are given: positions that
// sensors measure, or those of a simulator that does not keep loops closed.
#pragma once

#include <string>

#include "model/kinematic_tree.h"
#include "symbolic/derivative.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// q -> q with the dependent joints at positions that close the loops, by Newton's method from their given positions;
// NaN if it does not converge. For robots with loops that no formulas close.
symbolic::Program close_loops(const model::KinematicTree& tree, const std::string& name);

// q -> the rates of tree.followers_in_q(), a row for each, by those of the coordinates; nullopt if there are none.
symbolic::FollowerRates follower_rates(const model::KinematicTree& tree);

// The number of rows of the error of a loop.
int rows_of(model::LoopType type);

// positions of all joints -> errors of all loops, one after another. Each has the position of its second frame in its
// first one (m; for a slider only x and y). For a hinge, x and y of the second z axis in the first frame follow; for a
// slider and a weld, the axis of the rotation between the frames times the sine of its angle. A distance has only its
// excess (m).
symbolic::Program loop_error(const model::KinematicTree& tree, const std::string& name);

// Its derivative by the positions of all joints.
symbolic::Program loop_jacobian(const model::KinematicTree& tree, const std::string& name);

// q, qd -> velocities of all joints, in the order of joint_positions.
symbolic::Program joint_velocities(const model::KinematicTree& tree, const std::string& name);

// q, qd, qdd -> accelerations of all joints.
symbolic::Program joint_accelerations(const model::KinematicTree& tree, const std::string& name);

}  // namespace robcogen::algorithm
