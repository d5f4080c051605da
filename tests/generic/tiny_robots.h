// Robots that satisfy the concepts of generic code and compute nothing, so that their tests link no library.
#pragma once

#include <Eigen/Core>

#include "robcogen/concepts.h"

namespace robcogen::test {

template <bool kFloats>
struct TinyRobot {
  using Scalar = double;
  static constexpr int kDof = 2, kLinkCount = 3;
  static constexpr bool kFloatingBase = kFloats;
  using JointState = Eigen::Matrix<double, 2, 1>;
  using InertiaMatrix = Eigen::Matrix<double, kFloats ? 8 : 2, kFloats ? 8 : 2>;
  using Gravity = robcogen::Gravity;
  using Twist = robcogen::Twist;
  using SpatialAcceleration = robcogen::SpatialAcceleration;
  using GeneralizedAcceleration = robcogen::GeneralizedAcceleration<double, 2>;
  using InverseDynamics = robcogen::InverseDynamics<double, 2>;
  struct LinkWrenches {};

  // A third joint moves half as far as the second one.
  Eigen::Vector3d joint_positions(const JointState& q) const noexcept { return {q[0], q[1], q[1] / 2}; }
  Eigen::Vector3d joint_velocities(const JointState&, const JointState& qd) const noexcept {
    return {qd[0], qd[1], qd[1] / 2};
  }
};

using Fixed = TinyRobot<false>;
using Floating = TinyRobot<true>;

// Results as generated functions return them.
struct ConstrainedFixed {
  Eigen::Vector2d qdd;
  Eigen::Vector3d contact_wrenches;
};
struct ConstrainedFloating {
  Eigen::Vector2d qdd;
  SpatialAcceleration base_acceleration;
  Eigen::Vector3d contact_wrenches;
};
struct ImpactFixed {
  Eigen::Vector2d qd_after;
  Eigen::Vector3d contact_impulses;
};
struct ImpactFloating {
  Eigen::Vector2d qd_after;
  Twist base_velocity_after;
  Eigen::Vector3d contact_impulses;
};
struct LoopConstrained {
  Eigen::Vector3d accelerations;
  SpatialAcceleration base_acceleration;
  Eigen::Vector3d loop_forces;
};

}  // namespace robcogen::test
