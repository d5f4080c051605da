// What the drives of joints add to the dynamics.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// The inertia that the motion of this joint alone meets in its drive; zero without one.
Expression drive_inertia(Trace& trace, int joint);

// The forces that the joints have to overcome in their drives, by joint: damping.
std::vector<Expression> passive_forces(Trace& trace, const StateInputs& in);
// Adds them to the forces that a motion takes, or subtracts them from those that are there to move the robot.
void add_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau);
void subtract_passive_forces(Trace& trace, const StateInputs& in, std::vector<Expression>& tau);

}  // namespace robcogen::algorithm
