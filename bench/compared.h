// The quantities of one robot that other libraries compute too, computed by the generated code in the conventions of
// peers/peer.h.
#pragma once

#include <string>
#include <vector>

#include "agreement.h"
#include "functions.h"
#include "robcogen/results.h"

namespace robcogen::bench {

template <class R>
peers::State converted_state(const State<R>& s) {
  return {s.q, s.qd, s.qdd, s.tau, s.base_velocity.vector(), s.base_acceleration.vector()};
}

template <class R>
std::vector<peers::State> converted_states(const std::vector<State<R>>& states) {
  std::vector<peers::State> result;
  for (const State<R>& s : states) result.push_back(converted_state<R>(s));
  return result;
}

inline peers::Subject subject(const Robot& robot, const std::string& urdf) {
  peers::Subject result;
  result.urdf = urdf;
  for (const reflection::Joint& joint : robot.joints) result.joints.push_back(joint.name);
  result.floating_base = robot.floating_base;
  result.gravity = kStandardGravity.vector();
  if (const reflection::Jacobian* jacobian = compared_jacobian(robot)) result.link = urdf_link(robot, jacobian->right);
  return result;
}

// The result of a function as a column or a matrix, with the base first.
template <class Derived>
Eigen::MatrixXd flat(const Eigen::MatrixBase<Derived>& value) {
  return value;
}
inline Eigen::MatrixXd stacked(const Eigen::VectorXd& base, const Eigen::VectorXd& joints) {
  Eigen::MatrixXd result(base.size() + joints.size(), 1);
  result << base, joints;
  return result;
}
template <int kDof>
Eigen::MatrixXd flat(const GeneralizedForce<double, kDof>& value) {
  return stacked(value.base_wrench.vector(), value.tau);
}
template <int kDof>
Eigen::MatrixXd flat(const GeneralizedAcceleration<double, kDof>& value) {
  return stacked(value.base_acceleration.vector(), value.qdd);
}

// A Jacobian with one column for each joint: zero for joints outside the chain.
template <class R>
Eigen::MatrixXd full_jacobian(const reflection::Jacobian& jacobian, const State<R>& s) {
  Eigen::MatrixXd narrow(6, jacobian.column_count);
  jacobian.kernel(reference::cache_of(*s.robot), s.q.data(), narrow.data());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, s.q.size());
  for (int i = 0; i < jacobian.column_count; ++i) J.col(jacobian.columns[i]) = narrow.col(i);
  return J;
}

// The quantities that the library has. The states must outlive the result.
template <class R>
std::vector<Computed> computed(const Robot& robot, const std::vector<State<R>>& states) {
  std::vector<Computed> all;
  if constexpr (reference::kHasInverseDynamics) {
    all.push_back({peers::Quantity::inverse_dynamics, kInverseDynamics<R>, [&states](std::size_t i) {
                     return flat(inverse_dynamics<R>(states[i], states[i].q));
                   }});
  }
  if constexpr (reference::kHasForwardDynamics) {
    all.push_back({peers::Quantity::forward_dynamics, "forward_dynamics", [&states](std::size_t i) {
                     return flat(forward_dynamics<R>(states[i], states[i].q));
                   }});
  }
  if constexpr (reference::kHasInertia) {
    all.push_back({peers::Quantity::inertia_matrix, "joint_space_inertia", [&states](std::size_t i) {
                     return flat(states[i].robot->joint_space_inertia(states[i].q));
                   }});
  }
  if (const reflection::Jacobian* jacobian = compared_jacobian(robot)) {
    all.push_back({peers::Quantity::jacobian, benchmark_name(*jacobian), [&states, jacobian](std::size_t i) {
                     return full_jacobian(*jacobian, states[i]);
                   }});
  }
  if (const reflection::Transform* transform = compared_transform(robot)) {
    all.push_back({peers::Quantity::transform, benchmark_name(*transform), [&states, transform](std::size_t i) {
                     Eigen::MatrixXd X(4, 4);
                     transform->homogeneous(reference::cache_of(*states[i].robot), states[i].q.data(), X.data());
                     return X;
                   }});
  }
  return all;
}

}  // namespace robcogen::bench
