// An experiment in simulation: the HyL leg tracks a fast sinusoid (5 Hz) with its hip and knee, with the slider held
// and two control laws. It follows Frigerio et al., JOSER 7(1), 2016, 7.4, who did this with the leg of HyQ in
// hardware.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace tracking {

enum class Law {
  proportional_derivative,  // springs and dampers scaled by the inertia of each joint, without a model of the robot
  inverse_dynamics,         // computed torque
};

// Poles of both laws are at -kPole (1/s): they react equally to errors, and differ in the feedforward.
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
  Eigen::Vector2d rms;            // error of each joint, rad, after the initial transient
  Eigen::Vector2d largest;
  std::vector<double> loop_times;  // of the controller's computation, ns, one each cycle
};

// `rate` must divide 4000 Hz. All results except the loop times are the same in every run. Neither law models the
// friction in the joints or the lag of the actuators.
Result run(Law law, double rate, double duration);

}  // namespace tracking
