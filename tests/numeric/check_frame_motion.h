// Checks of what is about pairs of frames beside transforms and Jacobians, against the reference's Jacobians and
// differences of them in time. Each function records the errors of one sample.
#pragma once

#include "interpreted_robot.h"

namespace robcogen::numeric {

inline constexpr reference::Tolerance kFrameRate{
    "kFrameRate", 1e-11, "a fourth-order difference of 1e-4 rad of the reference, rounded as far as double has it"};

// All pairs that have Jacobians: the three references, the derivative, velocities and accelerations.
void check_frame_motions(const InterpretedRobot& robot, const reference::Case& c, reference::Checks& checks);

}  // namespace robcogen::numeric
