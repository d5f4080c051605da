// Time integration of all joints of a robot with loops, which loop_constrained_forward_dynamics moves. Needs C++20.
//
//     const auto a = robot.loop_constrained_forward_dynamics(state.positions, state.velocities, forces, gains,
//     compliance); state = integrate(state, a, h);
//
// Nothing allocates.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/generic/simulation.h"

namespace robcogen {

// Robots with the positions and velocities of all joints (group `transforms`), which are vectors of one size unless
// there are spherical joints.
template <class R>
concept HasAllJoints = RobotTraits<R> &&
    requires(const R& robot, const JointPositions<R>& q, const typename R::JointState& qd) {
  robot.joint_positions(q);
  robot.joint_velocities(q, qd);
};

// The number of all joints: those of qd, and those that follow them.
template <HasAllJoints R>
inline constexpr int kAllJoints = std::remove_cvref_t<decltype(std::declval<const R&>().joint_velocities(
    std::declval<const JointPositions<R>&>(),
    std::declval<const typename R::JointState&>()))>::RowsAtCompileTime;

namespace accelerations {

// Whether all positions are numbers, not quaternions.
template <HasAllJoints R>
inline constexpr bool kAddsPositions =
    kQuaternions<R>.size() == 0 && std::remove_cvref_t<decltype(std::declval<const R&>().joint_positions(
                                       std::declval<const JointPositions<R>&>()))>::RowsAtCompileTime
                                       == kAllJoints<R>;

}  // namespace accelerations

// Positions (rad, m) and velocities (rad/s, m/s) of all joints, in the order of joint_positions.
template <HasAllJoints R>
struct AllJointsState {
  using Vector = Eigen::Matrix<typename R::Scalar, kAllJoints<R>, 1>;
  static_assert(
      accelerations::kAddsPositions<R>,
      "positions of spherical joints cannot be added: integrate quaternions");
  Vector positions = Vector::Zero();
  Vector velocities = Vector::Zero();
};

// The velocity of the base is in base coordinates.
template <HasAllJoints R>
requires FloatingBase<R>
struct AllJointsState<R> {
  using Vector = Eigen::Matrix<typename R::Scalar, kAllJoints<R>, 1>;
  static_assert(
      accelerations::kAddsPositions<R>,
      "positions of spherical joints cannot be added: integrate quaternions");
  Vector positions = Vector::Zero();
  Vector velocities = Vector::Zero();
  BasicBasePose<typename R::Scalar> pose;
  typename R::Twist base_velocity;
};

// The same state in which all loops are closed.
template <HasAllJoints R>
AllJointsState<R> all_joints(const R& robot, const State<R>& state) noexcept {
  AllJointsState<R> result;
  result.positions = robot.joint_positions(state.q);
  result.velocities = robot.joint_velocities(state.q, state.qd);
  if constexpr (R::kFloatingBase) {
    result.pose = state.pose;
    result.base_velocity = state.base_velocity;
  }
  return result;
}

// A step of semi-implicit Euler, as for a State; `result` is that of loop_constrained_forward_dynamics. Loops stay
// closed up to errors of the step, which its argument `stabilization` removes.
template <HasAllJoints R, class Result>
AllJointsState<R> integrate(const AllJointsState<R>& state, const Result& result, typename R::Scalar h) noexcept {
  AllJointsState<R> next = state;
  if constexpr (accelerations::OfAllJoints<Result>) {
    next.velocities += h * result.accelerations;
    next.positions += h * next.velocities;
    if constexpr (R::kFloatingBase) {
      next.base_velocity = typename R::Twist(state.base_velocity.vector() + h * result.base_acceleration.vector());
      next.pose = integrate(state.pose, next.base_velocity, h);
    }
  } else {
    static_assert(
        accelerations::kNever<Result>,
        "the state has all joints: the accelerations must be a result of loop_constrained_forward_dynamics");
  }
  return next;
}

}  // namespace robcogen

#else
#error "robcogen/generic/all_joints.h needs C++20: compile with -std=c++20"
#endif
