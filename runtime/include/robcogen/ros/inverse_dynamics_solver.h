// A plugin for inverse_dynamics_solver (github.com/unisa-acg/inverse-dynamics-solver), over a generated robot.
// robcogen_add_ros_plugins makes one.
//
// initialize throws inverse_dynamics_solver::InvalidParameterValueException or ParameterUninitializedException; the
// other functions throw UninitializedException before, and std::invalid_argument for vectors of another size. They
// allocate only what they return, and any number of threads may call them.
#pragma once

#include <inverse_dynamics_solver/exceptions.h>
#include <inverse_dynamics_solver/inverse_dynamics_solver.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "robcogen/ros/chain.h"
#include "robcogen/ros/description.h"
#include "robcogen/ros/log.h"
#include "robcogen/ros/parameters.h"

namespace robcogen::ros {

// Parameters: `tip`, the last link of the joints that vectors hold, from `root` on (without `tip`, all joints of the
// robot), `joints`, these joints in another order, `gravity` (m/s^2) in axes of `root`, and `check_description`. Joints
// without an element are at rest at zero. The root must not move.
//
// Torques, inertia, Coriolis and gravity vectors leave out damping, friction and springs of joints, also if the
// robot's own functions include them; the friction vector holds damping and friction.
template <class R>
class InverseDynamicsSolver : public inverse_dynamics_solver::InverseDynamicsSolver {
 public:
  static_assert(!R::kFloatingBase, "inverse_dynamics_solver is for robots with a fixed base");

  using JointState = typename R::JointState;
  using Vector = Eigen::VectorXd;

  explicit InverseDynamicsSolver(const reflection::Robot& tables, const R& robot = R())
      : tables_(tables), robot_(robot), has_passive_forces_(tables.tendons.size > 0) {
    for (const reflection::Joint& joint : tables_.joints)
      has_passive_forces_ = has_passive_forces_ ||
                            (tables_.passive_forces &&
                             (joint.drive.damping != 0 || joint.drive.friction != 0 || joint.drive.stiffness != 0));
  }

  void initialize(
      rclcpp::node_interfaces::NodeParametersInterface::ConstSharedPtr parameters_interface = nullptr,
      const std::string& param_namespace = "",
      const std::string& robot_description = "") override {
    is_initialized_ = false;
    Parameters parameters(parameters_interface, param_namespace);
    const std::string root = parameters.text("root"), tip = parameters.text("tip");
    const auto joints = parameters.texts("joints");
    const auto gravity = parameters.numbers("gravity", {0, 0, -9.81});
    const bool checks = parameters.flag("check_description", true);
    if (!parameters.problem().empty()) refuse(parameters.problem());
    if (tip.empty() && !root.empty()) refuse("parameter 'root' needs 'tip'");
    const std::string problem =
        tip.empty() ? chain_.select_all(tables_, joints, robot_) : chain_.select(tables_, root, tip, joints, robot_);
    if (!problem.empty()) refuse(problem);
    if (chain_.base_moves()) refuse("link '" + root + "' moves: the root must be fixed to that of the robot");
    if (gravity.size() != 3) refuse(wrong_size("parameter 'gravity'", static_cast<long long>(gravity.size()), 3));
    if (!std::all_of(gravity.begin(), gravity.end(), [](double g) { return std::isfinite(g); }))
      refuse("an element of parameter 'gravity' is not a number");
    gravity_ = chain_.base_in_root().linear() * Eigen::Map<const Eigen::Vector3d>(gravity.data());
    if (checks) compare(parameters.robot_description(robot_description));
    is_initialized_ = true;
  }

  Eigen::MatrixXd getInertiaMatrix(const Vector& joint_positions) const override {
    return selected_matrix(robot_.joint_space_inertia(from("joint_positions", joint_positions)));
  }
  Vector getCoriolisVector(const Vector& joint_positions, const Vector& joint_velocities) const override {
    const JointState q = from("joint_positions", joint_positions), qd = from("joint_velocities", joint_velocities);
    return selected(robot_.coriolis_forces(q, qd));
  }
  Vector getGravityVector(const Vector& joint_positions) const override {
    return selected(robot_.gravity_forces(from("joint_positions", joint_positions), gravity()));
  }
  Vector getFrictionVector(const Vector& joint_velocities) const override {
    const JointState qd = from("joint_velocities", joint_velocities);
    JointState tau;
    for (int j = 0; j < R::kDof; ++j) tau[j] = friction(tables_.joints[j].drive, qd[j]);
    for (int c = 0; c < tables_.couplings.size; ++c) {
      const JointDrive& drive = tables_.joints[R::kDof + c].drive;
      if (drive.damping == 0 && drive.friction == 0) continue;  // factors may be no numbers
      const Eigen::Map<const JointState> factors(tables_.couplings[c].factors);
      tau += factors * friction(drive, factors.dot(qd));
    }
    return selected(tau);
  }
  Vector getTorques(const Vector& joint_positions, const Vector& joint_velocities, const Vector& joint_accelerations)
      const override {
    const JointState q = from("joint_positions", joint_positions), qd = from("joint_velocities", joint_velocities),
                     qdd = from("joint_accelerations", joint_accelerations);
    if (!has_passive_forces_) return selected(robot_.inverse_dynamics(q, qd, qdd, gravity()));
    return selected(JointState(
        robot_.joint_space_inertia(q) * qdd + robot_.coriolis_forces(q, qd) + robot_.gravity_forces(q, gravity())));
  }

 private:
  using Gravity = typename R::Gravity;

  const reflection::Robot& tables_;
  R robot_;
  Chain<R> chain_;
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();
  bool has_passive_forces_;
  bool is_initialized_ = false;

  std::string message(const std::string& text) const { return "robcogen." + std::string(tables_.name) + ": " + text; }
  [[noreturn]] void refuse(const std::string& text) const {
    throw inverse_dynamics_solver::InvalidParameterValueException(message(text));
  }

  void compare(const std::string& text) const {
    if (text.empty())
      throw inverse_dynamics_solver::ParameterUninitializedException(message("parameter 'robot_description'"));
    const auto model = urdf::parseURDF(text);
    if (!model) refuse("the robot description is not a URDF");
    std::string difference = difference_of_poses(tables_, *model, robot_);
    bool compared = true;
    if (difference.empty()) difference = difference_of_dynamics(tables_, *model, robot_, compared);
    if (!difference.empty()) refuse(difference);
    if (!compared)
      RCLCPP_WARN(
          rclcpp::get_logger("robcogen." + std::string(tables_.name)),
          "the masses of the robot description were not compared: it has joints that the library does not have, or the "
          "library has rotors");
  }

  Gravity gravity() const { return Gravity(gravity_); }

  JointState from(const char* name, const Vector& vector) const {
    if (!is_initialized_) throw inverse_dynamics_solver::UninitializedException();
    if (vector.size() != chain_.size())
      throw std::invalid_argument(message(wrong_size(name, vector.size(), chain_.size())));
    return chain_.positions(vector);
  }

  Vector selected(const JointState& all) const {
    Vector result(chain_.size());
    for (int i = 0; i < chain_.size(); ++i) result[i] = all[joint(i)];
    return result;
  }
  Eigen::MatrixXd selected_matrix(const typename R::InertiaMatrix& all) const {
    Eigen::MatrixXd result(chain_.size(), chain_.size());
    for (int i = 0; i < chain_.size(); ++i)
      for (int k = 0; k < chain_.size(); ++k) result(i, k) = all(joint(i), joint(k));
    return result;
  }
  int joint(int place) const { return chain_.joints()[static_cast<std::size_t>(place)]; }

  static double friction(const JointDrive& drive, double velocity) {
    const double v = drive.friction_velocity;
    const double direction = v > 0 ? velocity / std::sqrt(velocity * velocity + v * v)
                                   : static_cast<double>((velocity > 0) - (velocity < 0));
    return drive.damping * velocity + (drive.friction == 0 ? 0.0 : drive.friction * direction);
  }
};

}  // namespace robcogen::ros
