// Results of functions that have the accelerations of a robot: what steps of time integration take. Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <concepts>
#include <type_traits>

#include "robcogen/concepts.h"

namespace robcogen {

namespace accelerations {

template <RobotTraits R>
struct Of {
  using Type = typename R::JointState;
};
template <FloatingBase R>
struct Of<R> {
  using Type = typename R::GeneralizedAcceleration;
};

// A vector with one element per joint; expressions of Eigen too.
template <class A, class R>
concept JointVectorOf = std::is_convertible_v<const A&, typename R::JointState> &&
    (A::SizeAtCompileTime == R::kDof || A::SizeAtCompileTime == Eigen::Dynamic);

template <class A>
concept HasJoints = requires(const A& a) {
  a.qdd;
};
template <class A>
concept HasBase = requires(const A& a) {
  a.base_acceleration;
};
template <class A, class R>
concept HasJointsOf = HasJoints<A> && JointVectorOf<std::remove_cvref_t<decltype(A::qdd)>, R>;
template <class A, class R>
concept HasBaseOf =
    HasBase<A> && std::is_convertible_v<decltype(A::base_acceleration), typename R::SpatialAcceleration>;

// Results that are often mistaken for accelerations.
template <class A>
concept OfImpact = requires(const A& a) {
  a.qd_after;
};
template <class A>
concept OfAllJoints = requires(const A& a) {
  a.accelerations;
};
template <class A>
concept OfForces = requires(const A& a) {
  a.tau;
};

// False, once the type is known: with it, a message of static_assert stands alone, without what a concept requires.
template <class A>
inline constexpr bool kNever = !std::is_same_v<A, A>;

}  // namespace accelerations

// The accelerations of a robot: of its joints (rad/s^2, m/s^2), with a floating base together with the spatial
// acceleration of the base in base coordinates.
template <RobotTraits R>
using Accelerations = typename accelerations::Of<R>::Type;

// What has them: a vector with one element per joint, with a fixed base, or a result with a member `qdd` and, with a
// floating base, `base_acceleration`: those of forward_dynamics, constrained_forward_dynamics,
// forward_dynamics_derivatives, and structures of the user's own.
template <class A, class R>
concept AccelerationsOf = RobotTraits<R> &&
    ((FixedBase<R> && accelerations::JointVectorOf<A, R>) ||
     (accelerations::HasJointsOf<A, R> && (FixedBase<R> || accelerations::HasBaseOf<A, R>)));

// Refuses, with one message, what has no accelerations of R.
template <class R, class A>
constexpr void require_accelerations() {
  using namespace accelerations;
  if constexpr (AccelerationsOf<A, R>) {
    return;
  } else if constexpr (OfImpact<A>) {
    static_assert(kNever<A>, "an impact changes velocities at once: use after_impact(state, result)");
  } else if constexpr (OfAllJoints<A>) {
    static_assert(
        kNever<A>,
        "loop_constrained_forward_dynamics has the accelerations of all joints of the cut tree: integrate an "
        "AllJointsState (robcogen/generic/all_joints.h), or take the accelerations of forward_dynamics");
  } else if constexpr (HasBaseOf<A, R> && OfForces<A>) {
    static_assert(
        kNever<A>,
        "the result of inverse_dynamics has the acceleration of the base only: pass "
        "Robot::GeneralizedAcceleration{qdd, result.base_acceleration}");
  } else if constexpr (FloatingBase<R> && (HasJointsOf<A, R> || JointVectorOf<A, R>)) {
    static_assert(
        kNever<A>,
        "with a floating base, the acceleration of the base is missing: pass a result of forward dynamics, or "
        "Robot::GeneralizedAcceleration{qdd, base_acceleration}");
  } else if constexpr (HasJoints<A>) {
    static_assert(kNever<A>, "`qdd` is not a vector with one element for each joint of this robot");
  } else {
    static_assert(
        kNever<A>,
        "the accelerations must be a result with a member `qdd` and, with a floating base, `base_acceleration`; with a "
        "fixed base, a vector with one element per joint will do");
  }
}

// The accelerations in such a result.
template <RobotTraits R, AccelerationsOf<R> A>
Accelerations<R> accelerations_of(const A& a) noexcept {
  if constexpr (FloatingBase<R>) {
    return {a.qdd, a.base_acceleration};
  } else if constexpr (accelerations::HasJointsOf<A, R>) {
    return a.qdd;
  } else {
    return a;
  }
}

}  // namespace robcogen

#else
#error "robcogen/generic/accelerations.h needs C++20: compile with -std=c++20"
#endif
