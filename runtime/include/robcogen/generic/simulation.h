// Time integration of any robot, one step at a time. Needs C++20.
//
// Both methods take a function that returns the accelerations in a state, so the caller decides on joint forces,
// contacts and gravity. Its result is any that has accelerations (accelerations.h): that of forward_dynamics, of
// constrained_forward_dynamics, …
//
//     state = runge_kutta_step(state, h, [&](const auto& s) { return acceleration(robot, s, tau); });
//
// Nothing allocates.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/generic/accelerations.h"
#include "robcogen/generic/state.h"

namespace robcogen {

namespace simulation {

// Time derivative of a state as one vector: joint positions, then joint velocities; for a floating base also the
// coefficients of the orientation (x, y, z, w), position and velocity, from element kBaseRate on.
template <RobotTraits R>
inline constexpr int kBaseRate = kPositionCount<R> + R::kDof;
template <RobotTraits R>
using Rate = Matrix<typename R::Scalar, kBaseRate<R> + (R::kFloatingBase ? 13 : 0), 1>;

template <FixedBase R>
Rate<R> rate(const State<R>& state, const typename R::JointState& qdd) noexcept {
  Rate<R> result;
  result << position_rates<R>(state.q, state.qd), qdd;
  return result;
}

template <FloatingBase R>
Rate<R> rate(const State<R>& state, const typename R::GeneralizedAcceleration& a) noexcept {
  using Scalar = typename R::Scalar;
  // The angular velocity in base coordinates as a quaternion: dQ/dt = Q (w, 0) / 2.
  Eigen::Quaternion<Scalar> spin(0, 0, 0, 0);
  spin.vec() = state.base_velocity.angular() / 2;
  Rate<R> result;
  result << position_rates<R>(state.q, state.qd), a.qdd, (state.pose.quaternion() * spin).coeffs(),
      state.pose.to_world_axes(state.base_velocity.linear()), a.base_acceleration.vector();
  return result;
}

template <RobotTraits R>
State<R> advanced(const State<R>& state, const Rate<R>& rate, typename R::Scalar h) noexcept {
  State<R> result = state;
  // Quaternions are projected to the unit sphere, like that of the base below.
  result.q = normalised_positions<R>(state.q + h * rate.template head<kPositionCount<R>>());
  result.qd += h * rate.template segment<R::kDof>(kPositionCount<R>);
  if constexpr (R::kFloatingBase) {
    // The pose projects the quaternion to the unit sphere. The exact motion stays on it, so the order of the method
    // does not change.
    using Pose = BasicBasePose<typename R::Scalar>;
    const typename Pose::Vector4 quaternion = state.pose.quaternion_xyzw() + h * rate.template segment<4>(kBaseRate<R>);
    result.pose = Pose::from_quaternion(
        typename Pose::Quaternion(quaternion), state.pose.position() + h * rate.template segment<3>(kBaseRate<R> + 4));
    result.base_velocity = typename R::Twist(result.base_velocity.vector() + h * rate.template tail<6>());
  }
  return result;
}

}  // namespace simulation

// A step of semi-implicit Euler with constant accelerations, which change the velocities; the velocities at the end
// change the positions. First order; with a fixed base, energy oscillates without drift for small steps. A floating
// base moves exactly by its twist at the end; its orientation remains a rotation. The accelerations are any result that
// has them (accelerations.h).
template <RobotTraits R, class A = Accelerations<R>>
State<R> integrate(const State<R>& state, const A& accelerations, typename R::Scalar h) noexcept {
  require_accelerations<R, A>();
  State<R> result = state;
  if constexpr (AccelerationsOf<A, R>) {
    if constexpr (R::kFloatingBase) {
      result.qd += h * accelerations.qdd;
      result.base_velocity =
          typename R::Twist(state.base_velocity.vector() + h * accelerations.base_acceleration.vector());
      result.pose = integrate(state.pose, result.base_velocity, h);
    } else {
      result.qd += h * accelerations_of<R>(accelerations);
    }
    result.q = integrate_positions<R>(state.q, result.qd, h);
  }
  return result;
}

// The state after an impact, which changes velocities only: `after` is the result of `impact`.
template <RobotTraits R, accelerations::OfImpact After>
State<R> after_impact(const State<R>& state, const After& after) noexcept {
  State<R> result = state;
  result.qd = after.qd_after;
  if constexpr (R::kFloatingBase) result.base_velocity = after.base_velocity_after;
  return result;
}

// Semi-implicit Euler: first order, one evaluation of the dynamics.
template <RobotTraits R, class Acceleration>
State<R> semi_implicit_euler_step(const State<R>& state, typename R::Scalar h, const Acceleration& acceleration) {
  return integrate(state, acceleration(state), h);
}

// The classical method of Runge and Kutta: fourth order, four evaluations of the dynamics.
template <RobotTraits R, class Acceleration>
State<R> runge_kutta_step(const State<R>& state, typename R::Scalar h, const Acceleration& acceleration) {
  using simulation::Rate, simulation::rate, simulation::advanced;
  const auto rate_in = [&](const State<R>& s) {
    const auto& a = acceleration(s);
    using A = std::remove_cvref_t<decltype(a)>;
    require_accelerations<R, A>();
    if constexpr (AccelerationsOf<A, R>) {
      return rate<R>(s, accelerations_of<R>(a));
    } else {
      return Rate<R>();
    }
  };
  const Rate<R> a = rate_in(state);
  const Rate<R> b = rate_in(advanced<R>(state, a, h / 2));
  const Rate<R> c = rate_in(advanced<R>(state, b, h / 2));
  const Rate<R> d = rate_in(advanced<R>(state, c, h));
  return advanced<R>(state, (a + 2 * b + 2 * c + d) / 6, h);
}

}  // namespace robcogen

#else
#error "robcogen/generic/simulation.h needs C++20: compile with -std=c++20"
#endif
