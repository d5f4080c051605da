// Stand-in for the class of kinematics_interface, with the functions that its documentation lists. ROBCOGEN_HUMBLE and
// ROBCOGEN_JAZZY select the functions of these versions, otherwise those of Rolling.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <rclcpp/logging.hpp>
#include <rclcpp/node_interfaces/node_parameters_interface.hpp>
#include <string>
#include <vector>

namespace kinematics_interface {

class KinematicsInterface {
 public:
  using NodeParameters = std::shared_ptr<rclcpp::node_interfaces::NodeParametersInterface>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  virtual ~KinematicsInterface() = default;

#ifdef ROBCOGEN_HUMBLE
  virtual bool initialize(NodeParameters parameters, const std::string& end_effector) = 0;
#else
  virtual bool initialize(const std::string& description, NodeParameters parameters, const std::string& prefix) = 0;
  virtual bool calculate_jacobian_inverse(
      const Eigen::VectorXd& q,
      const std::string& link,
      Eigen::Matrix<double, Eigen::Dynamic, 6>& inverse) = 0;
#endif
#if !defined(ROBCOGEN_HUMBLE) && !defined(ROBCOGEN_JAZZY)
  virtual bool calculate_frame_difference(
      Eigen::Matrix<double, 7, 1>& a,
      Eigen::Matrix<double, 7, 1>& b,
      double dt,
      Vector6& difference) = 0;
#endif
  virtual bool convert_cartesian_deltas_to_joint_deltas(
      const Eigen::VectorXd& q,
      const Vector6& dx,
      const std::string& link,
      Eigen::VectorXd& dq) = 0;
  virtual bool convert_joint_deltas_to_cartesian_deltas(
      const Eigen::VectorXd& q,
      const Eigen::VectorXd& dq,
      const std::string& link,
      Vector6& dx) = 0;
  virtual bool calculate_link_transform(const Eigen::VectorXd& q, const std::string& link, Eigen::Isometry3d& X) = 0;
  virtual bool calculate_jacobian(
      const Eigen::VectorXd& q,
      const std::string& link,
      Eigen::Matrix<double, 6, Eigen::Dynamic>& J) = 0;

  // There are overloads for std::vector, which call these.
  bool convert_cartesian_deltas_to_joint_deltas(
      std::vector<double>& q,
      const std::vector<double>& dx,
      const std::string& link,
      std::vector<double>& dq) {
    Eigen::VectorXd result = vector(dq);
    const bool is_good = convert_cartesian_deltas_to_joint_deltas(vector(q), Vector6(vector(dx)), link, result);
    for (std::size_t j = 0; j < dq.size(); ++j) dq[j] = result[static_cast<Eigen::Index>(j)];
    return is_good;
  }
  bool convert_joint_deltas_to_cartesian_deltas(
      const std::vector<double>& q,
      const std::vector<double>& dq,
      const std::string& link,
      std::vector<double>& dx) {
    Vector6 result;
    const bool is_good = convert_joint_deltas_to_cartesian_deltas(vector(q), vector(dq), link, result);
    for (std::size_t j = 0; j < dx.size(); ++j) dx[j] = result[static_cast<Eigen::Index>(j)];
    return is_good;
  }
  bool calculate_link_transform(const std::vector<double>& q, const std::string& link, Eigen::Isometry3d& X) {
    return calculate_link_transform(vector(q), link, X);
  }
  bool calculate_jacobian(
      const std::vector<double>& q,
      const std::string& link,
      Eigen::Matrix<double, 6, Eigen::Dynamic>& J) {
    return calculate_jacobian(vector(q), link, J);
  }

 private:
  static Eigen::VectorXd vector(const std::vector<double>& numbers) {
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  }
};

}  // namespace kinematics_interface
