// A quadruped jumps from a squat: the first of the two design studies of Frigerio et al., JOSER 7(1), 2016, 7.5
// (Fig. 14a).
//
// The trunk is pushed upwards by 2.5 times the weight, and held level; the Jacobians of the feet map these forces to
// joint torques, which are limited. The ground is a spring and a damper below each foot, with friction.
#pragma once

#include <functional>
#include <vector>

#include "posture.h"

namespace design {

// Limits of the torques of hips and knees (N m) at given velocities. `lower` is at most zero, `upper` at least zero.
struct TorqueLimits {
  JointState lower, upper;
};
using Actuators = std::function<TorqueLimits(const JointState& qd)>;

// The same limit at all velocities; HUGE_VAL means no limit.
Actuators constant_limit(double torque);

// Electric motors with the gears of the parameters: the torque is proportional to the length of the motor, and thus to
// the inertia of its rotor, and falls to zero at the no-load velocity.
Actuators motors(const ParameterArray& parameters);

struct Jump {
  double rise;             // m, of the trunk from lift-off to the apex
  double lift_off_time;    // s
  double lift_off_speed;   // m/s, of the trunk, upwards
  std::vector<Feet> feet;  // in trunk axes, each millisecond until lift-off
};

// `start` is the height (m) of the trunk's origin above the ground in the squat, with the feet below the hips. Throws
// std::domain_error if the legs do not reach, or if the robot does not lift off.
Jump squat_jump(const Parameters& parameters, double start, const Actuators& actuators);

}  // namespace design
