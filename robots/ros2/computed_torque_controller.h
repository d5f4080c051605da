// A controller as ros2_control drives one: configured, activated, then updated in a real-time loop. It knows nothing of
// ROS; controller_plugin.cpp is the connection.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "robcogen/any_robot.h"

namespace demo_arm_control {

// Joint forces by inverse dynamics, with errors that decay as those of critically damped oscillators (Siciliano et al.,
// Robotics, 2009, 8.5.2), within the limits of the joints.
class ComputedTorqueController {
 public:
  // A robot with a fixed base; otherwise std::invalid_argument is thrown.
  explicit ComputedTorqueController(robcogen::AnyRobot robot);

  // `shoulder/effort`, in the order of the robot's joints.
  std::vector<std::string> command_interfaces() const;
  // `shoulder/position`, `shoulder/velocity` of each joint in turn.
  std::vector<std::string> state_interfaces() const;

  // The frequency of the oscillators (rad/s); false where it is not a positive number.
  bool configure(double frequency);
  // Holds the positions that these states have. False where a state is not finite.
  bool activate(std::span<const double> states);
  // Positions to go to (rad, m), between the limits of the joints; false, and nothing changes, where one is not.
  bool set_goal(std::span<const double> positions) noexcept;
  // Forces (N m, N) for the states, in the orders above. Allocates nothing. False where a state is not finite: the
  // commands are zero then.
  bool update(std::span<const double> states, std::span<double> commands) noexcept;

 private:
  robcogen::AnyRobot robot_;
  double frequency_ = 10;
  Eigen::VectorXd goal_, q_, qd_, qdd_, tau_;

  std::vector<std::string> interfaces(std::initializer_list<const char*> kinds) const;
  bool read(std::span<const double> states) noexcept;
};

}  // namespace demo_arm_control
