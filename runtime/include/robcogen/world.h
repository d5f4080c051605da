// A frame of a floating-base robot in the world: its Jacobian with the columns of the base, its acceleration, and
// forces that act there. Written over the generated functions from the base frame to the frame:
//
//     const Eigen::Matrix4d X = quadruped::transforms::homogeneous::fr_trunk_X_fr_LF_foot(q);
//     const auto joints = quadruped::jacobians::fr_trunk_J_fr_LF_foot(q);
//     const auto J = jacobian_with_base<quadruped::kDof>(X, joints,
//     quadruped::jacobians::fr_trunk_J_fr_LF_foot_columns);
//
// The left frame must be that of the base itself, here fr_trunk. Angular rows first; nothing allocates or throws.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "robcogen/rigid_exponential.h"
#include "robcogen/spatial.h"

namespace robcogen {

// 6 x (6 + n), base_X_frame and base_J_frame given: times the twist of the base and qd, the angular velocity of the
// frame and the velocity of its origin in the world, in base axes. Columns have the order of the joint-space inertia
// matrix; those of joints beyond the chain are zero. Its transpose maps a moment and a force at the origin of the
// frame, in base axes, to the wrench on the base and joint forces.
template <int kDof, class Scalar, int kColumns, class Columns>
Eigen::Matrix<Scalar, 6, 6 + kDof> jacobian_with_base(
    const Eigen::Matrix<Scalar, 4, 4>& base_X_frame,
    const Eigen::Matrix<Scalar, 6, kColumns>& base_J_frame,
    const Columns& columns) noexcept {
  const Eigen::Matrix<Scalar, 3, 1> origin = base_X_frame.template topRightCorner<3, 1>();
  Eigen::Matrix<Scalar, 6, 6 + kDof> J = Eigen::Matrix<Scalar, 6, 6 + kDof>::Zero();
  J.template leftCols<6>().setIdentity();
  J.template bottomLeftCorner<3, 3>() = -exponential::cross_matrix(origin);
  Eigen::Index column = 0;
  for (const auto joint : columns) J.col(6 + static_cast<Eigen::Index>(joint)) = base_J_frame.col(column++);
  return J;
}

// What is added to J (base_acceleration, qdd) in the angular acceleration of the frame (rad/s^2) and the acceleration
// of its origin (m/s^2) in the world, in base axes. J is jacobian_with_base, base_Jd_qd_frame the product of that name;
// the acceleration of the base is spatial, as forward dynamics returns it, and gravity is not included.
template <class Scalar, int kColumns, class Velocities>
Eigen::Matrix<Scalar, 6, 1> bias_acceleration_with_base(
    const Eigen::Matrix<Scalar, 4, 4>& base_X_frame,
    const Eigen::Matrix<Scalar, 6, kColumns>& J,
    const Eigen::Matrix<Scalar, 6, 1>& base_Jd_qd_frame,
    const BasicTwist<Scalar>& base_velocity,
    const Eigen::MatrixBase<Velocities>& qd) noexcept {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  const Vector3 origin = base_X_frame.template topRightCorner<3, 1>();
  const Vector3 w = base_velocity.angular(), v = base_velocity.linear();
  const Eigen::Matrix<Scalar, 6, 1> relative = J.template rightCols<kColumns - 6>() * qd;
  // Centripetal and Coriolis acceleration in the moving base (Siciliano et al., Robotics, 2009, 7.2.1).
  const Vector3 linear = relative.template tail<3>();
  Eigen::Matrix<Scalar, 6, 1> bias = base_Jd_qd_frame;
  bias.template head<3>() += w.cross(Vector3(relative.template head<3>()));
  bias.template tail<3>() += w.cross(v + w.cross(origin) + Scalar(2) * linear);
  return bias;
}

// The angular and the linear rows in other axes: of the world with R = pose.rotation(), of a frame with the transpose
// of the rotation in base_X_frame.
template <class Scalar, int kColumns>
Eigen::Matrix<Scalar, 6, kColumns> rows_in_axes(
    const Eigen::Matrix<Scalar, 3, 3>& R,
    const Eigen::Matrix<Scalar, 6, kColumns>& J) noexcept {
  Eigen::Matrix<Scalar, 6, kColumns> result;
  result.template topRows<3>() = R * J.template topRows<3>();
  result.template bottomRows<3>() = R * J.template bottomRows<3>();
  return result;
}

// A force (N) at a point (m), both in base coordinates, as the external wrench on a link: about the origin of the link
// and in its coordinates, for the functions that take external wrenches. base_X_link is that of the link's own frame.
template <class Scalar>
BasicWrench<Scalar> wrench_on_link(
    const Eigen::Matrix<Scalar, 4, 4>& base_X_link,
    const Eigen::Matrix<Scalar, 3, 1>& point,
    const Eigen::Matrix<Scalar, 3, 1>& force) noexcept {
  const Eigen::Matrix<Scalar, 3, 3> link_R_base = base_X_link.template topLeftCorner<3, 3>().transpose();
  const Eigen::Matrix<Scalar, 3, 1> arm = point - base_X_link.template topRightCorner<3, 1>();
  return BasicWrench<Scalar>(link_R_base * arm.cross(force), link_R_base * force);
}

}  // namespace robcogen
