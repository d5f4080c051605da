// Forces of a robot at rest as expressions, for algorithms that use them.
#pragma once

#include "algorithm/dynamics/newton_euler.h"

namespace robcogen::algorithm {

// The forces that hold the robot against gravity, in base coordinates: tau and base_wrench only.
Forces forces_at_rest(const TracedRobot& robot, const Vector3& gravity);

}  // namespace robcogen::algorithm
