// The poses of all frames of a robot.
#pragma once

#include <string>
#include <vector>

#include "algorithm/kinematics/path_pose.h"
#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// q -> poses: 12 rows and a column for each frame of the tree (`frames()`), in order: the x, y and z axes of the frame,
// then its origin (m), in the base. Each link is placed once, from its parent, so that the size of the program is
// proportional to that of the robot.
symbolic::Program frame_poses(const model::KinematicTree& tree, const std::string& name);

// The poses of the links in the base, by link: not of repeated links. `q` are the positions by joint.
std::vector<PathPose> link_poses(Trace& trace, const std::vector<Expression>& q);

}  // namespace robcogen::algorithm
