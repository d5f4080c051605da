// A controller for ros2_control: configured, activated, then updated in a real-time loop. It does not depend on ROS;
// controller_plugin.cpp connects it.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "robcogen/any_robot.h"

namespace demo_arm_control {

// Computes joint forces by inverse dynamics, within the limits of the joints. Errors decay like those of critically
// damped oscillators (Siciliano et al., Robotics, 2009, 8.5.2).
class ComputedTorqueController {
 public:
  // The robot must have a fixed base; otherwise std::invalid_argument is thrown.
  explicit ComputedTorqueController(robcogen::AnyRobot robot);

  // `shoulder/effort`, in the order of the robot's joints.
  std::vector<std::string> command_interfaces() const;
  // `shoulder/position`, `shoulder/velocity` of each joint in turn.
  std::vector<std::string> state_interfaces() const;

  // Sets the frequency of the oscillators (rad/s); returns false if it is not a positive number.
  bool configure(double frequency);
  // Holds the positions of these states. Returns false if a state is not finite.
  bool activate(std::span<const double> states);
  // Sets the positions to go to (rad, m). Returns false, without a change, if one is not between the limits of its
  // joint.
  bool set_goal(std::span<const double> positions) noexcept;
  // Computes forces (N m, N) for the states, in the orders above. Allocates nothing. Returns false if a state is not
  // finite; the commands are then zero.
  bool update(std::span<const double> states, std::span<double> commands) noexcept;

 private:
  robcogen::AnyRobot robot_;
  double frequency_ = 10;
  Eigen::VectorXd goal_, q_, qd_, qdd_, tau_;

  std::vector<std::string> interfaces(std::initializer_list<const char*> kinds) const;
  bool read(std::span<const double> states) noexcept;
};

}  // namespace demo_arm_control
