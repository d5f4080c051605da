// The robot with a floating base that these programs share, by its old and its own interface, and the same program for
// any scalar: its dynamics, whose derivatives the library has too.
#pragma once

#include <Eigen/Core>

#include <iit/Walker/floating_walker/floating_walker.h>
#include <iit/robots/floating_walker/traits.h>

namespace robcogen::test {

namespace old = iit::Walker;
namespace own = iit::Walker::floating_walker;

// All objects of a robot, as a program holds them that is generic over robots and over scalars.
template <class TRAITS>
struct Container {
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using SCALAR = typename TRAITS::S;
  using Vector6 = Eigen::Matrix<SCALAR, 6, 1>;
  using Joints = Eigen::Matrix<SCALAR, TRAITS::joints_count, 1>;

  Container()
      : jsim(inertias, force),
        forward(inertias, motion),
        inverse(inertias, motion),
        gravity(Vector6::Constant(SCALAR(0))) {
    gravity(3) = SCALAR(1.5);
    gravity(5) = SCALAR(-9.0);
    for (int i = 0; i < 6; ++i) {
      velocity(i) = SCALAR(0.4 - 0.3 * i);
      acceleration(i) = SCALAR(0.2 * i - 0.7);
    }
    q << SCALAR(0.3), SCALAR(-0.7), SCALAR(1.1);
    qd << SCALAR(0.5), SCALAR(-1.2), SCALAR(0.8);
    qdd << SCALAR(-0.4), SCALAR(2.0), SCALAR(0.6);
  }

  typename TRAITS::HomogeneousTransforms homogeneous;
  typename TRAITS::MotionTransforms motion;
  typename TRAITS::ForceTransforms force;
  typename TRAITS::Jacobians jacobians;
  typename TRAITS::InertiaProperties inertias;
  typename TRAITS::JSIM jsim;
  typename TRAITS::FwdDynEngine forward;
  typename TRAITS::InvDynEngine inverse;
  Vector6 gravity, velocity, acceleration;
  Joints q, qd, qdd;
};

// q, qd, qdd of the container.
inline Eigen::Matrix<double, 9, 1> motion() {
  const Container<old::Traits> robot;
  Eigen::Matrix<double, 9, 1> x;
  x << robot.q, robot.qd, robot.qdd;
  return x;
}

// Of q, qd and joint accelerations: the base wrench and joint forces of inverse dynamics; and, with the accelerations
// as joint forces, the accelerations of the base and of the joints by forward dynamics.
template <class Scalar>
Eigen::Matrix<Scalar, 18, 1> dynamics(const Eigen::Matrix<Scalar, 9, 1>& x) {
  Container<old::tpl::Traits<Scalar>> robot;
  const old::tpl::JointState<Scalar> q = x.template head<3>(), qd = x.template segment<3>(3),
                                     last = x.template tail<3>();
  old::tpl::JointState<Scalar> tau, qdd;
  Eigen::Matrix<Scalar, 6, 1> wrench, base_acceleration;
  robot.inverse.id_fully_actuated(wrench, tau, robot.gravity, robot.velocity, robot.acceleration, q, qd, last);
  robot.forward.fd(qdd, base_acceleration, robot.velocity, robot.gravity, q, qd, last);
  Eigen::Matrix<Scalar, 18, 1> y;
  y << wrench, tau, base_acceleration, qdd;
  return y;
}

// The derivatives of `dynamics` at `motion`, by the library's functions.
inline Eigen::Matrix<double, 18, 9> derivatives_of_dynamics() {
  const Container<old::Traits> robot;
  const robcogen::Twist velocity(robot.velocity);
  const robcogen::Gravity gravity(robot.gravity.tail<3>());
  const auto inverse = own::inverse_dynamics_fully_actuated_derivatives(
      robot.q, robot.qd, robot.qdd, velocity, robcogen::SpatialAcceleration(robot.acceleration), gravity);
  const auto forward = own::forward_dynamics_derivatives(robot.q, robot.qd, robot.qdd, velocity, gravity);
  Eigen::Matrix<double, 18, 9> derivatives;
  derivatives << inverse.d_q, inverse.d_qd, inverse.d_qdd, forward.d_q, forward.d_qd, forward.d_tau;
  return derivatives;
}

}  // namespace robcogen::test
