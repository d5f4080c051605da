// Two robots swing up from hanging to upright with drives that are too weak to lift them there directly. Iterative LQR
// finds the inputs, with generated derivatives of forward dynamics.
#pragma once

#include <cart_pole/cart_pole.h>
#include <puma560_control/puma560_control.h>

#include <Eigen/Core>
#include <vector>

#include "ilqr.h"

namespace optimal_control {

// States are q and qd. An input u of a joint is the force limit * tanh(u), so that limits hold without constraints.
template <int dof, int inputs>
struct Motion {
  static constexpr int kDof = dof;
  double time_step;  // s
  Eigen::Matrix<double, inputs, 1> limits;
  Trajectory<2 * dof, inputs> trajectory;

  Eigen::Matrix<double, inputs, 1> force(std::size_t step) const {
    return limits.cwiseProduct(trajectory.u[step].array().tanh().matrix());
  }
};

// A step of semi-implicit Euler. The first joints of the robot are driven, one for each input. `derivatives(q, qd,
// tau)` and `dynamics(q, qd, tau)` are the generated functions.
template <int dof, int inputs, class Dynamics, class Derivatives>
auto step_of(
    double h,
    const Eigen::Matrix<double, inputs, 1>& limits,
    const Dynamics& dynamics,
    const Derivatives& derivatives) {
  using Joints = Eigen::Matrix<double, dof, 1>;
  return [=](const Eigen::Matrix<double, 2 * dof, 1>& x, const Eigen::Matrix<double, inputs, 1>& u,
             Linearisation<2 * dof, inputs>* linearisation) {
    const Joints q = x.template head<dof>(), qd = x.template tail<dof>();
    const Eigen::Matrix<double, inputs, 1> share = u.array().tanh().matrix();
    Joints tau = Joints::Zero();
    tau.template head<inputs>() = limits.cwiseProduct(share);
    Joints qdd;
    if (linearisation) {
      const auto d = derivatives(q, qd, tau);
      qdd = d.qdd;
      // qd' = qd + h qdd, q' = q + h qd'
      Eigen::Matrix<double, dof, 2 * dof> by_state;
      by_state << h * d.d_q, h * d.d_qd;
      by_state.template rightCols<dof>() += Eigen::Matrix<double, dof, dof>::Identity();
      linearisation->A.template bottomRows<dof>() = by_state;
      linearisation->A.template topRows<dof>() = h * by_state;
      linearisation->A.template topLeftCorner<dof, dof>() += Eigen::Matrix<double, dof, dof>::Identity();
      const Eigen::Matrix<double, inputs, 1> slope = limits.cwiseProduct((1 - share.array().square()).matrix());
      linearisation->B.template bottomRows<dof>() = h * d.d_tau.template leftCols<inputs>() * slope.asDiagonal();
      linearisation->B.template topRows<dof>() = h * linearisation->B.template bottomRows<dof>();
    } else {
      qdd = dynamics(q, qd, tau);
    }
    Eigen::Matrix<double, 2 * dof, 1> next;
    next.template tail<dof>() = qd + h * qdd;
    next.template head<dof>() = q + h * next.template tail<dof>();
    return next;
  };
}

// The steps of both robots, declared for the tests.
Eigen::Vector4d cart_pole_step(
    const Eigen::Vector4d& x,
    const Eigen::Matrix<double, 1, 1>& u,
    Linearisation<4, 1>* linearisation);
Eigen::Matrix<double, 12, 1> puma_step(
    const Eigen::Matrix<double, 12, 1>& x,
    const Eigen::Matrix<double, 6, 1>& u,
    Linearisation<12, 6>* linearisation);

using CartPoleMotion = Motion<2, 1>;
using PumaMotion = Motion<6, 6>;
CartPoleMotion swing_up_cart_pole();
PumaMotion swing_up_puma();

}  // namespace optimal_control
