// A frame as seen from another one: its position and its motion. They are computed in each frame of the path, from the
// last joint to the first: a joint adds its own motion to that seen from behind it, and everything is rotated to the
// axes of the frame before.
#pragma once

#include <vector>

#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm {

// The target's origin with its derivatives by time, its angular velocity and the derivative of that, all relative to
// the observing frame and in its axes.
struct Seen {
  Vector3 position, velocity, acceleration;
  Vector3 w, wd;
};

// The path with the segment of the target first.
Path path_from_target(const model::KinematicTree& tree, const model::FramePair& frames);

// A joint's rate or acceleration, in the direction in which the path passes it.
Expression along(const JointOnPath& passed, const std::vector<Expression>& values);

// The target of a path from target to left, as seen from left. Positions, rates and accelerations by joint.
Seen seen_from(
    Trace& trace,
    const Path& path,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd);

}  // namespace robcogen::algorithm
