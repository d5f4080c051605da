// The acceleration of frames in a motion of the robot.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// The origin of a frame, in the frame that the recursions use for its link.
Vector3 origin_of(const TracedRobot& robot, const model::Frame& frame);

// Angular acceleration of a frame and acceleration of its origin in an inertial frame, in base axes, minus gravity if
// `motions` include it. `motions`: by link, as newton_euler_forces returns them.
Motion acceleration_of(const TracedRobot& robot, const std::vector<LinkMotion>& motions, const model::Frame& frame);

}  // namespace robcogen::algorithm
