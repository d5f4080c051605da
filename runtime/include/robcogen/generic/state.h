// Position and velocity of any robot, and its dynamics in a state. Only this file treats a floating base differently.
// Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/concepts.h"
#include "robcogen/matrix.h"
#include "robcogen/pose.h"
#include "robcogen/positions.h"

namespace robcogen {

// Joint positions (rad, m) and velocities (rad/s, m/s).
template <RobotTraits R>
struct ROBCOGEN_ALIGNED State {
  JointPositions<R> q = neutral_positions<R>();
  typename R::JointState qd = R::JointState::Zero();
};

// The velocity of the base is in base coordinates, like all quantities of the base.
template <FloatingBase R>
struct State<R> {
  JointPositions<R> q = neutral_positions<R>();
  typename R::JointState qd = R::JointState::Zero();
  BasicBasePose<typename R::Scalar> pose;
  typename R::Twist base_velocity;
};

// Standard gravity in base coordinates.
template <FloatingBase R>
typename R::Gravity gravity_in_base(const State<R>& state) noexcept {
  return gravity_in_base(state.pose);
}

// Accelerations under joint forces (N m, N) and standard gravity: of the joints (rad/s^2, m/s^2), and also of a
// floating base.
template <HasForwardDynamics R>
auto acceleration(const R& robot, const State<R>& state, const typename R::JointState& tau) noexcept {
  if constexpr (R::kFloatingBase) {
    return robot.forward_dynamics(state.q, state.qd, tau, state.base_velocity, gravity_in_base(state));
  } else {
    return robot.forward_dynamics(state.q, state.qd, tau);
  }
}

// Joint forces (N m, N) that give the joints these accelerations under standard gravity. No wrench acts on a floating
// base.
template <HasInverseDynamics R>
typename R::JointState joint_forces(const R& robot, const State<R>& state, const typename R::JointState& qdd) noexcept {
  if constexpr (R::kFloatingBase) {
    return robot.inverse_dynamics(state.q, state.qd, qdd, state.base_velocity, gravity_in_base(state)).tau;
  } else {
    return robot.inverse_dynamics(state.q, state.qd, qdd);
  }
}

}  // namespace robcogen

#else
#error "robcogen/generic/state.h needs C++20: compile with -std=c++20"
#endif
