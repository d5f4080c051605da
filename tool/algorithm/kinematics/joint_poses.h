// The poses of a robot's links.
#pragma once

#include <vector>

#include "algorithm/spatial/pose.h"

namespace robcogen::algorithm {

// The pose of the child link frame in the parent link frame, for every joint, from the robot's motions document.
std::vector<Pose> joint_poses(Trace& trace, const std::vector<Expression>& q);

// The same with all joints at zero; for spherical joints, the frames of joint and child coincide.
std::vector<Pose> poses_at_rest(Trace& trace);

}  // namespace robcogen::algorithm
