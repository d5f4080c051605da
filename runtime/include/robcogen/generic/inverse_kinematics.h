// One step of inverse kinematics for any chain of joints, by damped least squares. Needs C++20.
//
// Transforms and Jacobians have different names in each library, so the caller provides them:
//
//     struct Foot {
//       using JointState = hyl::JointState;
//       static auto pose(const JointState& q) { return hyl::transforms::homogeneous::fr_base_X_fr_foot(q); }
//       static auto jacobian(const JointState& q) { return hyl::jacobians::fr_base_J_fr_foot(q); }
//       static constexpr auto kColumns = hyl::jacobians::fr_base_J_fr_foot_columns;
//     };
//     q = inverse_kinematics_step(Foot(), q, target, 1e-6);
//
// Nothing allocates.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <concepts>

#include "robcogen/matrix.h"

namespace robcogen {

// A chain from a frame A to a frame B: pose(q) is A_X_B (4 x 4), and jacobian(q) is A_J_B (6 rows), with one column for
// each joint that kColumns lists.
template <class C>
concept KinematicChain = requires(const C& chain, const typename C::JointState& q) {
  requires decltype(chain.pose(q))::RowsAtCompileTime == 4;
  requires decltype(chain.jacobian(q))::RowsAtCompileTime == 6;
  requires decltype(chain.jacobian(q))::ColsAtCompileTime == static_cast<int>(C::kColumns.size());
};

// The motion from one pose to another: the axis times the angle of the rotation (rad), at most half a turn, then the
// displacement of the origin (m). It is in coordinates of the frame in which both poses are given.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> pose_error(const Matrix<Scalar, 4, 4>& from, const Matrix<Scalar, 4, 4>& to) noexcept {
  using Matrix3 = Matrix<Scalar, 3, 3>;
  const Matrix3 turn = to.template topLeftCorner<3, 3>() * from.template topLeftCorner<3, 3>().transpose();
  const Eigen::AngleAxis<Scalar> rotation(turn);
  Eigen::Matrix<Scalar, 6, 1> error;
  error << rotation.angle() * rotation.axis(),
      to.template topRightCorner<3, 1>() - from.template topRightCorner<3, 1>();
  return error;
}

// Returns the joint positions after one step towards `target`, a pose like chain.pose(q): q + J^T (J J^T + mu)^-1 e
// with the pose error e and mu = damping + |e|^2 / 2. The damping (positive) keeps steps short at singularities; the
// second term keeps them short for far targets and vanishes at the target (Sugihara, IEEE T-RO 27(5), 2011). Rotations
// (rad) and displacements (m) have equal weight; joints outside the chain do not move.
template <KinematicChain C>
typename C::JointState inverse_kinematics_step(
    const C& chain,
    const typename C::JointState& q,
    const Matrix<typename C::JointState::Scalar, 4, 4>& target,
    typename C::JointState::Scalar damping) noexcept {
  using Scalar = typename C::JointState::Scalar;
  using Matrix6 = Matrix<Scalar, 6, 6>;
  const Eigen::Matrix<Scalar, 6, 1> error = pose_error<Scalar>(chain.pose(q), target);
  const auto J = chain.jacobian(q);
  const Matrix6 damped = J * J.transpose() + (damping + error.squaredNorm() / 2) * Matrix6::Identity();
  const auto step = (J.transpose() * damped.llt().solve(error)).eval();
  typename C::JointState result = q;
  Eigen::Index row = 0;
  for (const auto joint : C::kColumns) result[static_cast<int>(joint)] += step[row++];
  return result;
}

}  // namespace robcogen

#else
#error "robcogen/generic/inverse_kinematics.h needs C++20: compile with -std=c++20"
#endif
