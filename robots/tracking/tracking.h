// An experiment in simulation: the HyL leg tracks a fast sinusoid (5 Hz) with its hip and knee, its slider held, under
// two control laws. After Frigerio et al., JOSER 7(1), 2016, 7.4, where the leg of HyQ did so in hardware.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace tracking {

enum class Law {
  proportional_derivative,  // springs and dampers scaled by the inertia of each joint, without a model of the robot
  inverse_dynamics,         // computed torque
};

// Both laws place their poles here, 1/s: they react equally to errors, and differ in the feedforward.
inline constexpr double kPole = 40;
inline constexpr double kFrequency = 5;  // Hz, of the motion

// Angles of HFE and KFE, rad.
struct Instant {
  double time;  // s
  Eigen::Vector2d wanted;
  Eigen::Vector2d found;
};

struct Result {
  Law law;
  double rate;                    // Hz, of the controller
  std::vector<Instant> instants;  // one each millisecond
  Eigen::Vector2d rms;            // error of each joint, rad, once the start is forgotten
  Eigen::Vector2d largest;
  std::vector<double> loop_times;  // of the controller's computation, ns, one each cycle
};

// `rate` divides 4000 Hz. All results except the loop times are the same in every run. Neither law models the friction
// in the joints and the lag of the actuators.
Result run(Law law, double rate, double duration);

}  // namespace tracking
