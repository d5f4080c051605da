// The comparisons of designs: curves over one parameter, and searches over several.
#pragma once

#include <vector>

#include "search.h"
#include "squat_jump.h"
#include "trot_power.h"

namespace design {

// All lengths are in m. The jump varies the length of the lower leg with a constant upper leg, as in the paper; the
// trot varies the position of the knee.
inline constexpr double kUpperLength = 0.364;
inline constexpr double kTotalLength = 0.68;
inline constexpr double kStarts[] = {0.50, 0.55};     // heights of the trunk in the squat
inline constexpr double kSpeeds[] = {0.3, 0.6, 1.0};  // m/s
inline constexpr double kTorqueLimit = 150;           // N m

ParameterArray with_lengths(double upper, double lower);

struct Sample {
  double x, value;
};

// Rise of the trunk divided by the length of the lower leg, for lengths from 0.26 m to 0.48 m in steps of 0.02 m.
std::vector<Sample> jump_curve(double start, double torque_limit);
double normalised_rise(double lower_length, double start, double torque_limit);

// Mechanical power (W) of hip and knee of a leg over the ratio of the lengths of upper and lower leg.
std::vector<Sample> trot_curve(double speed);

// The best lower leg, to a millimetre; the value is minus the normalised rise.
Optimum best_jump(double start, double torque_limit);

// Minus the rise (m) as a function of upper and lower leg, together not longer than 0.70 m; the second problem also
// varies the ratio of the gears and the inertia of the rotors of electric motors.
Problem jump_of_lengths();
Problem jump_of_lengths_and_motors();

// Power of a leg (W) as a function of upper and lower leg, together not shorter than 0.66 m. The first problem has the
// mechanical power, the second the electric power, and also varies ratio and inertia.
Problem trot_of_lengths(double speed);
Problem trot_of_lengths_and_motors(double speed);

}  // namespace design
