// Joint positions of any robot: their type, how they move, and the difference between two of them.
//
// The positions of a spherical joint are a unit quaternion: four elements w, x, y, z of q, for three of qd. It rotates
// coordinates of the child to those of the joint frame, and its velocity is the angular velocity (rad/s) of the child
// with respect to the parent, in axes of the child. All other positions are numbers (rad, m), one for each element of
// qd. A robot with spherical joints has a type JointPositions of its own, and lists the elements of q at which its
// quaternions begin: kQuaternions. A robot with loops that no formulas close has that type, too: the last elements of
// q, its followers, are joints whose positions close_loops finds. For all other robots, positions and velocities are
// vectors of the same type, and they can be added.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <type_traits>

namespace robcogen {

namespace positions {

template <class R, class = void>
struct Of {
  using Type = typename R::JointState;
  static constexpr std::array<int, 0> kQuaternions = {};
};
template <class R, class = void>
struct FollowersOf {
  static constexpr std::array<double, 0> kAssembled = {};
};
template <class R>
struct FollowersOf<R, std::void_t<decltype(R::kAssembledFollowers)>> {
  static constexpr auto kAssembled = R::kAssembledFollowers;
};
// The positions at which loops are assembled, one for each element of qd.
template <class R, class = void>
struct CoordinatesOf {
  static constexpr std::array<double, 0> kAssembled = {};
};
template <class R>
struct CoordinatesOf<R, std::void_t<decltype(R::kAssembledCoordinates)>> {
  static constexpr auto kAssembled = R::kAssembledCoordinates;
};
template <class R>
struct Of<R, std::void_t<typename R::JointPositions>> {
  using Type = typename R::JointPositions;
  static constexpr auto kQuaternions = R::kQuaternions;
};

}  // namespace positions

// The type of q, and how many elements it has. `R` is the type Robot of a generated library.
template <class R>
using JointPositions = typename positions::Of<R>::Type;
template <class R>
inline constexpr int kPositionCount = JointPositions<R>::SizeAtCompileTime;
// The elements of q at which quaternions begin, in order.
template <class R>
inline constexpr auto kQuaternions = positions::Of<R>::kQuaternions;

// The number of followers, the last elements of q, which follow the others through loops that no formulas close.
template <class R>
inline constexpr int kFollowerCount = static_cast<int>(positions::FollowersOf<R>::kAssembled.size());

namespace positions {

// Calls quaternion(first index in q, first index in qd) for each quaternion, and number(index in q, index in qd) for
// each other element that is not a follower.
template <class R, class Quaternion, class Number>
void visit(const Quaternion& quaternion, const Number& number) noexcept {
  int velocity = 0;
  std::size_t next = 0;
  for (int k = 0; k < kPositionCount<R> - kFollowerCount<R>;) {
    if (next < kQuaternions<R>.size() && kQuaternions<R>[next] == k) {
      quaternion(k, velocity);
      k += 4;
      velocity += 3;
      ++next;
    } else {
      number(k++, velocity++);
    }
  }
}

template <class Vector>
auto quaternion_at(const Vector& q, int k) noexcept {
  return Eigen::Quaternion<typename Vector::Scalar>(q[k], q[k + 1], q[k + 2], q[k + 3]);
}

template <class Vector, class Quaternion>
void set_quaternion(Vector& q, int k, const Quaternion& value) noexcept {
  q[k] = value.w();
  q[k + 1] = value.x();
  q[k + 2] = value.y();
  q[k + 3] = value.z();
}

}  // namespace positions

// Zero, or the positions at which loops are assembled. The frames of child and joint coincide for spherical joints, and
// followers are where their loops close.
template <class R>
JointPositions<R> neutral_positions() noexcept {
  JointPositions<R> q = JointPositions<R>::Zero();
  for (const int k : kQuaternions<R>) q[k] = 1;
  constexpr auto coordinates = positions::CoordinatesOf<R>::kAssembled;
  if constexpr (coordinates.size() > 0)
    positions::visit<R>(
        [](int, int) {},
        [&](int k, int velocity) {
          q[k] = static_cast<typename R::Scalar>(coordinates[static_cast<std::size_t>(velocity)]);
        });
  constexpr auto assembled = positions::FollowersOf<R>::kAssembled;
  for (std::size_t k = 0; k < assembled.size(); ++k)
    q[kPositionCount<R> - kFollowerCount<R> + static_cast<int>(k)] = static_cast<typename R::Scalar>(assembled[k]);
  return q;
}

// The same positions with quaternions of unit length, as functions of robots require.
template <class R>
JointPositions<R> normalised_positions(JointPositions<R> q) noexcept {
  for (const int k : kQuaternions<R>) q.template segment<4>(k).normalize();
  return q;
}

// The positions after `duration` (s) with constant velocities qd. Spherical joints turn exactly, about a fixed axis;
// quaternions keep unit length. Followers stay where they were, for close_loops, which must come next.
template <class R>
JointPositions<R> move_coordinates(
    const JointPositions<R>& q,
    const typename R::JointState& qd,
    typename R::Scalar duration) noexcept {
  using Scalar = typename R::Scalar;
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  JointPositions<R> result = q;
  positions::visit<R>(
      [&](int k, int velocity) {
        const Vector3 half = qd.template segment<3>(velocity) * (duration / 2);
        const Scalar angle = half.norm();
        // sin(angle) / angle, by its series where the next term does not change the quaternion.
        constexpr Scalar kSmall = Scalar(1e-3);
        const Scalar quotient = angle > kSmall ? std::sin(angle) / angle : 1 - angle * angle / 6;
        Eigen::Quaternion<Scalar> turn(std::cos(angle), 0, 0, 0);
        turn.vec() = quotient * half;
        positions::set_quaternion(result, k, (positions::quaternion_at(q, k) * turn).normalized());
      },
      [&](int k, int velocity) { result[k] = q[k] + duration * qd[velocity]; });
  return result;
}

// The same for robots without followers, whose positions are then complete.
template <class R>
JointPositions<R> integrate_positions(
    const JointPositions<R>& q,
    const typename R::JointState& qd,
    typename R::Scalar duration) noexcept {
  static_assert(kFollowerCount<R> == 0, "call move_coordinates, then close_loops: it moves the others");
  return move_coordinates<R>(q, qd, duration);
}

// The motion from one position to another, one element per velocity: integrate_positions(from, result, 1) = to. A
// spherical joint turns in the shorter direction, by at most half a turn (rad, in axes of the child). Followers do not
// enter: they move with the coordinates.
template <class R>
typename R::JointState position_difference(const JointPositions<R>& from, const JointPositions<R>& to) noexcept {
  using Scalar = typename R::Scalar;
  typename R::JointState way;
  positions::visit<R>(
      [&](int k, int velocity) {
        const Eigen::Quaternion<Scalar> turn =
            positions::quaternion_at(from, k).conjugate() * positions::quaternion_at(to, k);
        const Scalar sine = turn.vec().norm(), cosine = std::abs(turn.w());
        // The angle of the turn divided by the sine of its half, without loss of digits for small turns.
        const Scalar factor = sine > 0 ? 2 * std::atan2(sine, cosine) / sine : Scalar(2);
        way.template segment<3>(velocity) = (turn.w() < 0 ? -factor : factor) * turn.vec();
      },
      [&](int k, int velocity) { way[velocity] = to[k] - from[k]; });
  return way;
}

// dq/dt at velocities qd. For a quaternion Q it is Q (0, w) / 2 with the angular velocity w, which does not have unit
// length. For robots without followers.
template <class R>
JointPositions<R> position_rates(const JointPositions<R>& q, const typename R::JointState& qd) noexcept {
  static_assert(kFollowerCount<R> == 0, "joint_velocities has the rates of joints that follow through loops");
  using Scalar = typename R::Scalar;
  JointPositions<R> result;
  positions::visit<R>(
      [&](int k, int velocity) {
        Eigen::Quaternion<Scalar> spin(0, 0, 0, 0);
        spin.vec() = qd.template segment<3>(velocity) / 2;
        positions::set_quaternion(result, k, positions::quaternion_at(q, k) * spin);
      },
      [&](int k, int velocity) { result[k] = qd[velocity]; });
  return result;
}

}  // namespace robcogen
