// A frame as another one sees it: where it is and how it moves. It is told from each frame of the path, from the last
// joint to the first: as seen from a frame, a joint adds to what is seen from behind it, and everything turns into the
// axes of the frame before.
#pragma once

#include <vector>

#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm {

// The target's origin with its derivatives by time, its angular velocity and the derivative of that, all in the axes of
// the frame that sees it and as seen from there.
struct Seen {
  Vector3 position, velocity, acceleration;
  Vector3 w, wd;
};

// The path with the segment of the target first.
Path path_from_target(const model::KinematicTree& tree, const model::FramePair& frames);

// A joint's rate or acceleration, the way that the path passes it.
Expression along(const JointOnPath& passed, const std::vector<Expression>& values);

// The target of a path from target to left, as left sees it. Positions, rates and accelerations by joint.
Seen seen_from(
    Trace& trace,
    const Path& path,
    const std::vector<Expression>& q,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd);

}  // namespace robcogen::algorithm
