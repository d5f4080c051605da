#include "computed_torque_controller.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace demo_arm_control {

ComputedTorqueController::ComputedTorqueController(robcogen::AnyRobot robot) : robot_(std::move(robot)) {
  if (robot_.floating_base()) throw std::invalid_argument("ComputedTorqueController: the robot must have a fixed base");
  if (robot_.position_count() != robot_.dof())
    throw std::invalid_argument("ComputedTorqueController: the robot must have no spherical joints");
  for (Eigen::VectorXd* vector : {&goal_, &q_, &qd_, &qdd_, &tau_}) vector->setZero(robot_.dof());
}

std::vector<std::string> ComputedTorqueController::interfaces(std::initializer_list<const char*> kinds) const {
  std::vector<std::string> names;
  for (int j = 0; j < robot_.dof(); ++j)
    for (const char* kind : kinds) names.push_back(std::string(robot_.tables().joints[j].name) + "/" + kind);
  return names;
}

std::vector<std::string> ComputedTorqueController::command_interfaces() const {
  return interfaces({"effort"});
}

std::vector<std::string> ComputedTorqueController::state_interfaces() const {
  return interfaces({"position", "velocity"});
}

bool ComputedTorqueController::configure(double frequency) {
  if (!std::isfinite(frequency) || frequency <= 0) return false;
  frequency_ = frequency;
  return true;
}

bool ComputedTorqueController::read(std::span<const double> states) noexcept {
  if (states.size() != 2 * static_cast<std::size_t>(robot_.dof())) return false;
  for (Eigen::Index j = 0; j < q_.size(); ++j) {
    q_[j] = states[2 * static_cast<std::size_t>(j)];
    qd_[j] = states[2 * static_cast<std::size_t>(j) + 1];
  }
  return q_.allFinite() && qd_.allFinite();
}

bool ComputedTorqueController::activate(std::span<const double> states) {
  if (!read(states)) return false;
  goal_ = q_;
  return true;
}

bool ComputedTorqueController::set_goal(std::span<const double> positions) noexcept {
  if (positions.size() != static_cast<std::size_t>(robot_.dof())) return false;
  for (std::size_t j = 0; j < positions.size(); ++j) {
    const robcogen::JointLimits& limits = robot_.joint_limits()[j];
    if (!(positions[j] >= limits.lower && positions[j] <= limits.upper)) return false;
  }
  std::copy(positions.begin(), positions.end(), goal_.data());
  return true;
}

bool ComputedTorqueController::update(std::span<const double> states, std::span<double> commands) noexcept {
  std::fill(commands.begin(), commands.end(), 0.0);
  if (commands.size() != static_cast<std::size_t>(robot_.dof()) || !read(states)) return false;
  qdd_ = frequency_ * frequency_ * (goal_ - q_) - 2 * frequency_ * qd_;
  robot_.inverse_dynamics(q_, qd_, qdd_, tau_);
  for (std::size_t j = 0; j < commands.size(); ++j) {
    const double most = robot_.joint_limits()[j].effort;
    commands[j] = std::clamp(tau_[static_cast<Eigen::Index>(j)], -most, most);
  }
  return true;
}

}  // namespace demo_arm_control
