// The dynamics of robots that a program picks at run time (any_robot.h). Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include "robcogen/any/robot.h"

namespace robcogen {

inline SpatialAcceleration AnyRobot::inverse_dynamics(In q, In v, In qdd, Out tau) const {
  return inverse_dynamics(q, v, qdd, tau, default_gravity("inverse_dynamics"));
}

inline SpatialAcceleration AnyRobot::inverse_dynamics(
    In q,
    In v,
    In qdd,
    Out tau,
    const Gravity& gravity,
    External external) const {
  constexpr const char* kFunction = "inverse_dynamics";
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "v", v.size(), size());
  expect(kFunction, "qdd", qdd.size(), dof());
  expect(kFunction, "tau", tau.size(), dof());
  return functions_->inverse_dynamics(q.data(), v.data(), qdd.data(), tau.data(), loads(kFunction, gravity, external));
}

inline void AnyRobot::inverse_dynamics_fully_actuated(In q, In v, In a, Out f) const {
  inverse_dynamics_fully_actuated(q, v, a, f, default_gravity("inverse_dynamics_fully_actuated"));
}

inline void AnyRobot::inverse_dynamics_fully_actuated(
    In q,
    In v,
    In a,
    Out f,
    const Gravity& gravity,
    External external) const {
  constexpr const char* kFunction = "inverse_dynamics_fully_actuated";
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "v", v.size(), size());
  expect(kFunction, "a", a.size(), size());
  expect(kFunction, "f", f.size(), size());
  functions_->inverse_dynamics_fully_actuated(
      q.data(), v.data(), a.data(), f.data(), loads(kFunction, gravity, external));
}

inline void AnyRobot::forward_dynamics(In q, In v, In tau, Out a) const {
  forward_dynamics(q, v, tau, a, default_gravity("forward_dynamics"));
}

inline void AnyRobot::forward_dynamics(In q, In v, In tau, Out a, const Gravity& gravity, External external) const {
  constexpr const char* kFunction = "forward_dynamics";
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "v", v.size(), size());
  expect(kFunction, "tau", tau.size(), dof());
  expect(kFunction, "a", a.size(), size());
  functions_->forward_dynamics(q.data(), v.data(), tau.data(), a.data(), loads(kFunction, gravity, external));
}

inline void AnyRobot::bias_forces(In q, In v, Out f) const {
  bias_forces(q, v, f, default_gravity("bias_forces"));
}

inline void AnyRobot::bias_forces(In q, In v, Out f, const Gravity& gravity, External external) const {
  constexpr const char* kFunction = "bias_forces";
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "v", v.size(), size());
  expect(kFunction, "f", f.size(), size());
  functions_->bias_forces(q.data(), v.data(), f.data(), loads(kFunction, gravity, external));
}

inline void AnyRobot::gravity_forces(In q, Out f) const {
  gravity_forces(q, f, default_gravity("gravity_forces"));
}

inline void AnyRobot::gravity_forces(In q, Out f, const Gravity& gravity) const {
  constexpr const char* kFunction = "gravity_forces";
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "f", f.size(), size());
  functions_->gravity_forces(q.data(), f.data(), gravity);
}

inline void AnyRobot::coriolis_forces(In q, In v, Out f) const {
  constexpr const char* kFunction = "coriolis_forces";
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "v", v.size(), size());
  expect(kFunction, "f", f.size(), size());
  functions_->coriolis_forces(q.data(), v.data(), f.data());
}

inline void AnyRobot::joint_space_inertia(In q, OutMatrix H) const {
  constexpr const char* kFunction = "joint_space_inertia";
  expect(kFunction, "q", q.size(), position_count());
  expect(kFunction, "a column of H", H.rows(), size());
  expect(kFunction, "a row of H", H.cols(), size());
  functions_->joint_space_inertia(q.data(), H);
}

}  // namespace robcogen

#else
#error "robcogen/any/dynamics.h needs C++20: compile with -std=c++20"
#endif
