// Stand-in for the class of inverse_dynamics_solver, with the functions that its documentation lists.
#pragma once

#include <Eigen/Core>
#include <rclcpp/node_interfaces/node_parameters_interface.hpp>
#include <string>
#include <tuple>

namespace inverse_dynamics_solver {

class InverseDynamicsSolver {
 public:
  using Vector = Eigen::VectorXd;

  virtual ~InverseDynamicsSolver() = default;
  virtual void initialize(
      rclcpp::node_interfaces::NodeParametersInterface::ConstSharedPtr parameters = nullptr,
      const std::string& prefix = "",
      const std::string& description = "") = 0;
  virtual Eigen::MatrixXd getInertiaMatrix(const Vector& q) const = 0;
  virtual Vector getCoriolisVector(const Vector& q, const Vector& qd) const = 0;
  virtual Vector getGravityVector(const Vector& q) const = 0;
  virtual Vector getFrictionVector(const Vector& qd) const = 0;
  virtual std::tuple<Eigen::MatrixXd, Vector, Vector> getDynamicParameters(const Vector& q, const Vector& qd) const {
    return {getInertiaMatrix(q), getCoriolisVector(q, qd), getGravityVector(q)};
  }
  virtual Vector getTorques(const Vector& q, const Vector& qd, const Vector& qdd) const {
    return getInertiaMatrix(q) * qdd + getCoriolisVector(q, qd) + getGravityVector(q);
  }
};

}  // namespace inverse_dynamics_solver
