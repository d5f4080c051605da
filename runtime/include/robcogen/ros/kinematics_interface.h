// A plugin for kinematics_interface of ros2_control, over a generated robot. robcogen_add_ros_plugins makes one.
//
// It fits the versions of Humble (initialize has the name of the end effector), Jazzy, and Rolling (with
// calculate_frame_difference): functions that a version lacks are then ordinary members. Functions return false and log
// why, and none of them allocates unless it fails.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <kinematics_interface/kinematics_interface.hpp>
#include <memory>
#include <string>
#include <vector>

#include "robcogen/ros/chain.h"
#include "robcogen/ros/description.h"
#include "robcogen/ros/log.h"
#include "robcogen/ros/parameters.h"

namespace robcogen::ros {

// Parameters: `tip`, the last link (Humble: the argument), `base`, the first one (without it, the root), `joints`, the
// joints in the order of the vectors (without it, from base to tip), `alpha`, the damping of the inverse, and
// `check_description`. Deltas and Jacobians have linear rows first, in axes of the base.
template <class R>
class KinematicsInterface : public kinematics_interface::KinematicsInterface {
 public:
  using NodeParameters = rclcpp::node_interfaces::NodeParametersInterface;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Vector7 = Eigen::Matrix<double, 7, 1>;
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  using JacobianInverse = Eigen::Matrix<double, Eigen::Dynamic, 6>;

  explicit KinematicsInterface(const reflection::Robot& tables, const R& robot = R())
      : tables_(tables), robot_(robot) {}

  // The overloads for std::vector, and those that a version has beside these.
  using kinematics_interface::KinematicsInterface::calculate_jacobian;
  using kinematics_interface::KinematicsInterface::calculate_link_transform;
  using kinematics_interface::KinematicsInterface::convert_cartesian_deltas_to_joint_deltas;
  using kinematics_interface::KinematicsInterface::convert_joint_deltas_to_cartesian_deltas;

  // Without `override`, because no version declares all of them.

  virtual bool initialize(
      const std::string& robot_description,
      std::shared_ptr<NodeParameters> parameters_interface,
      const std::string& param_namespace) {
    Parameters parameters(parameters_interface, param_namespace);
    return initialize(parameters, parameters.text("tip"), robot_description);
  }
  virtual bool initialize(std::shared_ptr<NodeParameters> parameters_interface, const std::string& end_effector_name) {
    Parameters parameters(parameters_interface, "");
    return initialize(parameters, end_effector_name, "");
  }

  virtual bool calculate_link_transform(
      const Eigen::VectorXd& joint_pos,
      const std::string& link_name,
      Eigen::Isometry3d& transform) {
    const int link = check(joint_pos, link_name);
    if (link < 0) return false;
    transform = chain_.pose(chain_.positions(joint_pos), link);
    return true;
  }

  virtual bool calculate_jacobian(const Eigen::VectorXd& joint_pos, const std::string& link_name, Jacobian& jacobian) {
    const int link = check(joint_pos, link_name);
    if (link < 0 || !has_columns("jacobian", jacobian.cols())) return false;
    chain_.jacobian(chain_.positions(joint_pos), link, jacobian);
    return true;
  }

  virtual bool calculate_jacobian_inverse(
      const Eigen::VectorXd& joint_pos,
      const std::string& link_name,
      JacobianInverse& jacobian_inverse) {
    const int link = check(joint_pos, link_name);
    if (link < 0 || !has_columns("jacobian_inverse", jacobian_inverse.rows())) return false;
    Inverse inverse;
    if (!invert(joint_pos, link, inverse)) return false;
    jacobian_inverse = inverse;
    return true;
  }

  virtual bool convert_joint_deltas_to_cartesian_deltas(
      const Eigen::VectorXd& joint_pos,
      const Eigen::VectorXd& delta_theta,
      const std::string& link_name,
      Vector6& delta_x) {
    const int link = check(joint_pos, link_name);
    if (link < 0 || !has_elements("delta_theta", delta_theta.size())) return false;
    SmallJacobian J = jacobian_of(joint_pos, link);
    delta_x.noalias() = J * delta_theta;
    return true;
  }

  virtual bool convert_cartesian_deltas_to_joint_deltas(
      const Eigen::VectorXd& joint_pos,
      const Vector6& delta_x,
      const std::string& link_name,
      Eigen::VectorXd& delta_theta) {
    const int link = check(joint_pos, link_name);
    if (link < 0 || !has_elements("delta_theta", delta_theta.size())) return false;
    Inverse inverse;
    if (!invert(joint_pos, link, inverse)) return false;
    delta_theta.noalias() = inverse * delta_x;
    return true;
  }

  // Twist that leads from frame a to frame b in the time dt, in the axes in which both are given. It does not depend on
  // the robot, and works before initialisation.
  virtual bool calculate_frame_difference(Vector7& x_a, Vector7& x_b, double dt, Vector6& delta_x) {
    if (!(dt > 0) || !std::isfinite(dt)) return refuse("dt must be positive");
    const Eigen::Quaterniond a(x_a[6], x_a[3], x_a[4], x_a[5]), b(x_b[6], x_b[3], x_b[4], x_b[5]);
    if (!(a.norm() > 0) || !(b.norm() > 0)) return refuse("a quaternion of the frames is zero, or not a number");
    const Eigen::AngleAxisd turn(b.normalized() * a.normalized().conjugate());
    delta_x << (x_b.head<3>() - x_a.head<3>()) / dt, turn.angle() / dt * turn.axis();
    return true;
  }

 private:
  using SmallJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, R::kDof>;
  using Inverse = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, R::kDof, 6>;

  const reflection::Robot& tables_;
  R robot_;
  Chain<R> chain_;
  bool is_initialized_ = false;
  double alpha_ = 0;

  bool refuse(const std::string& text) const { return ros::refuse(tables_.name, text); }

  bool initialize(Parameters& parameters, const std::string& tip, const std::string& description) {
    is_initialized_ = false;
    if (tip.empty()) return refuse("the end effector is not set: parameter 'tip'");
    const std::string problem =
        chain_.select(tables_, parameters.text("base"), tip, parameters.texts("joints"), robot_);
    alpha_ = parameters.number("alpha", 5e-6);  // as in kinematics_interface_kdl
    const bool checks = parameters.flag("check_description", true);
    if (!parameters.problem().empty()) return refuse(parameters.problem());
    if (!problem.empty()) return refuse(problem);
    if (!(alpha_ >= 0) || !std::isfinite(alpha_)) return refuse("parameter 'alpha' must not be negative");
    if (checks) {
      const std::string text = parameters.robot_description(description);
      if (text.empty()) return refuse("there is no robot description: parameter 'robot_description'");
      const auto model = urdf::parseURDF(text);
      if (!model) return refuse("the robot description is not a URDF");
      const std::string difference = difference_of_poses(tables_, *model, robot_);
      if (!difference.empty()) return refuse(difference);
    }
    is_initialized_ = true;
    return true;
  }

  // The index of the link; -1, with a message, if the arguments do not fit.
  int check(const Eigen::VectorXd& joint_pos, const std::string& link_name) const {
    if (!is_initialized_) return refuse("initialize has not been called, or has failed"), -1;
    if (!has_elements("joint_pos", joint_pos.size())) return -1;
    const int link = chain_.find(link_name);
    if (link < 0) refuse(chain_.no_link(link_name));
    return link;
  }
  bool has_elements(const char* name, Eigen::Index size) const {
    return size == chain_.size() || refuse(wrong_size(name, size, chain_.size()));
  }
  bool has_columns(const char* name, Eigen::Index count) const {
    return count == chain_.size() || refuse(
                                         std::string(name) + " is for " + std::to_string(count) +
                                         " joints instead of " + std::to_string(chain_.size()));
  }

  SmallJacobian jacobian_of(const Eigen::VectorXd& joint_pos, int link) const {
    SmallJacobian J(6, chain_.size());
    chain_.jacobian(chain_.positions(joint_pos), link, J);
    return J;
  }

  // Sets `inverse` to (J^T J + alpha 1)^-1 J^T: of both equal forms, the one with the smaller matrix.
  bool invert(const Eigen::VectorXd& joint_pos, int link, Inverse& inverse) const {
    constexpr int kMost = std::min(6, R::kDof);
    using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMost, kMost>;
    const SmallJacobian J = jacobian_of(joint_pos, link);
    const bool is_slim = chain_.size() < 6;
    Small A(is_slim ? chain_.size() : 6, is_slim ? chain_.size() : 6);
    if (is_slim)
      A = J.transpose().lazyProduct(J);
    else
      A = J.lazyProduct(J.transpose());
    A.diagonal().array() += alpha_;
    const Eigen::LLT<Small> factor(A);
    // Next to a singular position, rounding decides whether the factor exists: its pivots tell.
    constexpr double kLeastPivot = 1e-7;
    const auto pivots = factor.matrixLLT().diagonal();
    if (factor.info() != Eigen::Success || !(pivots.minCoeff() > kLeastPivot * pivots.maxCoeff()))
      return refuse("the Jacobian has no inverse here: set parameter 'alpha' to a positive number");
    if (is_slim)
      inverse = factor.solve(J.transpose());
    else
      inverse = factor.solve(J).transpose();
    return true;
  }
};

}  // namespace robcogen::ros
