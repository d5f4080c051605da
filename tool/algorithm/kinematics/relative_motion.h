// The position and the motion of a target frame relative to another frame. A recursion along the path between the
// frames computes them relative to each frame of the path, from the last joint to the first: a joint adds its own
// motion, and all vectors are rotated to the axes of the next frame.
#pragma once

#include <vector>

#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm {

// The target's origin with its derivatives by time, its angular velocity and the derivative of that, all relative to
// the other frame and in its axes.
struct RelativeMotion {
  Vector3 position, velocity, acceleration;
  Vector3 w, wd;
};

// The path with the segment of the target first.
Path path_from_target(const model::KinematicTree& tree, const model::FramePair& frames);

// A joint's rate or acceleration, in the direction in which the path passes it.
Expression along(const JointOnPath& passed, const std::vector<Expression>& values);

// The motion of the target of a path from target to left, relative to left. Positions, rates and accelerations by
// joint.
RelativeMotion relative_motion(
    Trace& trace,
    const Path& path,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd);

}  // namespace robcogen::algorithm
