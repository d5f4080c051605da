// Computed torque: the joints of any robot follow a trajectory like masses on springs. Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/generic/state.h"

namespace robcogen {

// A point of a trajectory.
template <RobotTraits R>
struct ROBCOGEN_ALIGNED Setpoint {
  JointPositions<R> q = neutral_positions<R>();
  typename R::JointState qd = R::JointState::Zero();
  typename R::JointState qdd = R::JointState::Zero();
};

// Gains of each joint: acceleration per position error (1/s^2) and per velocity error (1/s).
template <RobotTraits R>
struct ROBCOGEN_ALIGNED Gains {
  typename R::JointState stiffness;
  typename R::JointState damping;
};

// Gains with both poles at -pole (1/s) in all joints: the error is e(t) = (e + (de/dt + pole e) t) exp(-pole t).
template <RobotTraits R>
Gains<R> critically_damped(typename R::Scalar pole) noexcept {
  return {R::JointState::Constant(pole * pole), R::JointState::Constant(2 * pole)};
}

// Joint forces (N m, N) by inverse dynamics (Siciliano et al., Robotics, 2009, 8.5.2). If no wrench acts on a floating
// base, the joints follow the trajectory, and the base moves accordingly.
template <HasInverseDynamics R>
typename R::JointState computed_torque(
    const R& robot,
    const State<R>& state,
    const Setpoint<R>& wanted,
    const Gains<R>& gains) noexcept {
  const typename R::JointState qdd = wanted.qdd + gains.damping.cwiseProduct(wanted.qd - state.qd) +
                                     gains.stiffness.cwiseProduct(position_difference<R>(state.q, wanted.q));
  return joint_forces(robot, state, qdd);
}

}  // namespace robcogen

#else
#error "robcogen/generic/computed_torque.h needs C++20: compile with -std=c++20"
#endif
