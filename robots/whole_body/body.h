// The requirements of whole-body control on a robot on feet, and the points at which it touches the ground.
//
// A body names a generated robot and adds information that the robot's functions lack: where its contact frames are,
// which of their points touch the ground, and the standing posture.
#pragma once

#include <robcogen/generic/state.h>

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <vector>

namespace whole_body {

using Eigen::Matrix3d, Eigen::Matrix4d, Eigen::Vector3d;

template <class B>
concept Body = robcogen::FloatingBase<typename B::Robot> && robcogen::HasForwardDynamics<typename B::Robot> &&
    robcogen::HasBiasForces<typename B::Robot> && robcogen::HasJointSpaceInertia<typename B::Robot> &&
    robcogen::HasJointSpaceInertiaFactor<typename B::Robot> && robcogen::HasCentroidal<typename B::Robot> &&
    robcogen::HasContacts<typename B::Robot> && requires(const typename B::Robot::JointState& q) {
  { B::kContacts } -> std::convertible_to<int>;
  { B::kPointsPerContact } -> std::convertible_to<int>;
  { B::kMass } -> std::convertible_to<double>;  // kg
  // base_X_contact, in the order of the rows of the contact functions.
  { B::contact_frames(q) } -> std::same_as<std::array<Matrix4d, B::kContacts>>;
  // Points that touch the ground, in coordinates of the contact frame.
  { B::contact_points() } -> std::same_as<std::array<Vector3d, B::kPointsPerContact>>;
  // The standing posture.
  { B::posture() } -> std::same_as<typename B::Robot::JointState>;
};

template <Body B>
using StateOf = robcogen::State<typename B::Robot>;

template <Body B>
struct Sizes {
  static constexpr int kDof = B::Robot::kDof, kCoordinates = 6 + kDof;
  static constexpr int kRows = robcogen::kContactRows<typename B::Robot>;
  static constexpr int kRowsPerContact = kRows / B::kContacts;  // 3 or 6
  static constexpr int kPoints = B::kContacts * B::kPointsPerContact;
  using Coordinates = Eigen::Matrix<double, kCoordinates, 1>;
  using Rows = Eigen::Matrix<double, kRows, 1>;
  using PointVector = Eigen::Matrix<double, 3 * kPoints, 1>;  // three elements per point, world axes
};

template <Body B>
typename Sizes<B>::Coordinates velocity_of(const StateOf<B>& s) {
  return (typename Sizes<B>::Coordinates() << s.base_velocity.vector(), s.qd).finished();
}

// The points of all contacts in a state.
template <Body B>
struct ContactPoints {
  using S = Sizes<B>;

  explicit ContactPoints(const StateOf<B>& state) {
    const Matrix3d R = state.pose.rotation();
    const auto frames = B::contact_frames(state.q);
    const auto points = B::contact_points();
    for (int i = 0; i < S::kPoints; ++i) {
      const Matrix4d& X = frames[static_cast<std::size_t>(i / B::kPointsPerContact)];
      const Vector3d arm = X.topLeftCorner<3, 3>() * points[static_cast<std::size_t>(i % B::kPointsPerContact)];
      const Vector3d in_base = arm + X.topRightCorner<3, 1>();
      positions.col(i) = state.pose.position() + R * in_base;
      const int row = i / B::kPointsPerContact * S::kRowsPerContact;
      if constexpr (S::kRowsPerContact == 6) {
        map.template block<3, 3>(3 * i, row) = -R * robcogen::exponential::cross_matrix<double>(arm);
        map.template block<3, 3>(3 * i, row + 3) = R;
      } else {
        map.template block<3, 3>(3 * i, row) = R;
      }
    }
  }

  // Maps rows of contact velocities to velocities of the points in world axes; its transpose maps forces at the points
  // to contact wrenches.
  Eigen::Matrix<double, 3 * S::kPoints, S::kRows> map = Eigen::Matrix<double, 3 * S::kPoints, S::kRows>::Zero();
  Eigen::Matrix<double, 3, S::kPoints> positions;  // in the world
};

// The state of a standing robot, whose lowest contact point is on the ground, z = 0.
template <Body B>
StateOf<B> standing_state() {
  StateOf<B> state;
  state.q = B::posture();
  const double lowest = ContactPoints<B>(state).positions.row(2).minCoeff();
  state.pose = robcogen::BasePose::from_rpy(0, 0, 0, Vector3d(0, 0, -lowest));
  return state;
}

template <Body B>
Vector3d center_of_mass(const StateOf<B>& state) {
  return state.pose.position() + state.pose.to_world_axes(typename B::Robot().center_of_mass(state.q));
}

template <Body B>
Vector3d com_velocity(const StateOf<B>& state) {
  return state.pose.to_world_axes(typename B::Robot().center_of_mass_jacobian(state.q) * velocity_of<B>(state));
}

}  // namespace whole_body
