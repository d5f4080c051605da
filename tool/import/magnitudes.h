// Bounds on the magnitude of the quantities of a robot.
#pragma once

#include <string>
#include <string_view>

namespace robcogen::import {

// No quantity of a robot is this large in SI units. Beyond this bound, products of a few quantities would overflow.
inline constexpr double kTooLarge = 1e15;
// A quantity this small is treated as zero: its reciprocal would overflow.
inline constexpr double kZero = 1e-60;

// Returns the message about a quantity that is not below the bound. `what` is its value or a description of it.
std::string too_large(std::string_view what);

// Returns the message about an angle (rad) of this many turns or more, which is probably in degrees; empty for others.
std::string large_angle(double angle, double turns);
// A joint may turn more than once, but beyond this many turns its position is probably in degrees.
inline constexpr double kTurnsOfJoint = 4.0;

}  // namespace robcogen::import
