// Frames of a floating-base robot in the world: where they are, how they move, their Jacobians with the columns of the
// base, and forces that act there. Written over the generated functions from the base frame to the frame:
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

#include "robcogen/matrix.h"
#include "robcogen/pose.h"
#include "robcogen/rigid_exponential.h"
#include "robcogen/spatial.h"

namespace robcogen {

// world_X_frame.
template <class Scalar>
Matrix<Scalar, 4, 4> homogeneous_in_world(
    const BasicBasePose<Scalar>& pose,
    const typename BasicBasePose<Scalar>::Matrix4& base_X_frame) noexcept {
  return pose.homogeneous() * base_X_frame;
}

// The position in the world (m) of a point given in base coordinates (m), such as center_of_mass.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> position_in_world(
    const BasicBasePose<Scalar>& pose,
    const Eigen::Matrix<Scalar, 3, 1>& point) noexcept {
  return pose.position() + pose.to_world_axes(point);
}

// Angular velocity of a frame (rad/s), then the velocity of its origin (m/s), in the world and in its axes.
// base_V_frame is the generated velocity of the frame with respect to the base.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> velocity_in_world(
    const BasicBasePose<Scalar>& pose,
    const BasicTwist<Scalar>& base_velocity,
    const typename BasicBasePose<Scalar>::Matrix4& base_X_frame,
    const BasicTwist<Scalar>& base_V_frame) noexcept {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  const Vector3 origin = base_X_frame.template topRightCorner<3, 1>();
  const BasicTwist<Scalar> V = base_velocity + base_V_frame;
  Eigen::Matrix<Scalar, 6, 1> result;
  result << pose.to_world_axes(V.angular()), pose.to_world_axes(V.linear() + V.angular().cross(origin));
  return result;
}

// Angular acceleration of a frame (rad/s^2), then the acceleration of its origin (m/s^2): the time derivative of
// velocity_in_world. The acceleration of the base is spatial, as forward dynamics returns it, base_A_frame the
// generated acceleration of the frame with respect to the base.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> acceleration_in_world(
    const BasicBasePose<Scalar>& pose,
    const BasicTwist<Scalar>& base_velocity,
    const BasicSpatialAcceleration<Scalar>& base_acceleration,
    const typename BasicBasePose<Scalar>::Matrix4& base_X_frame,
    const BasicTwist<Scalar>& base_V_frame,
    const BasicSpatialAcceleration<Scalar>& base_A_frame) noexcept {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  const Vector3 origin = base_X_frame.template topRightCorner<3, 1>();
  const Vector3 w = base_velocity.angular(), v = base_velocity.linear();
  const Vector3 w_frame = base_V_frame.angular(), v_frame = base_V_frame.linear();
  // Base and frame together, with the spatial cross product of their velocities (Featherstone 2008, sec. 2.11).
  const Vector3 angular = base_acceleration.angular() + base_A_frame.angular() + w.cross(w_frame);
  const Vector3 linear = base_acceleration.linear() + base_A_frame.linear() + w.cross(v_frame) + v.cross(w_frame);
  const Vector3 spin = w + w_frame;
  Eigen::Matrix<Scalar, 6, 1> result;
  result << pose.to_world_axes(angular),
      pose.to_world_axes(linear + angular.cross(origin) + spin.cross(v + v_frame + spin.cross(origin)));
  return result;
}

// The Jacobian of a frame with the columns of the base, 6 x (6 + n), from base_X_frame and base_J_frame. Multiplied by
// the twist of the base and qd, it gives the angular velocity of the frame and the velocity of its origin in the world,
// in base axes. Columns have the order of the joint-space inertia matrix; those of joints outside the chain are zero.
// Its transpose maps a moment and a force at the origin of the frame, in base axes, to the wrench on the base and joint
// forces.
template <int kDof, class Jacobian, class Columns>
Matrix<typename Jacobian::Scalar, 6, 6 + kDof> jacobian_with_base(
    const Matrix<typename Jacobian::Scalar, 4, 4>& base_X_frame,
    const Eigen::MatrixBase<Jacobian>& base_J_frame,
    const Columns& columns) noexcept {
  using Scalar = typename Jacobian::Scalar;
  const Eigen::Matrix<Scalar, 3, 1> origin = base_X_frame.template topRightCorner<3, 1>();
  Matrix<Scalar, 6, 6 + kDof> J = Matrix<Scalar, 6, 6 + kDof>::Zero();
  J.template leftCols<6>().setIdentity();
  J.template bottomLeftCorner<3, 3>() = -exponential::cross_matrix(origin);
  Eigen::Index column = 0;
  for (const auto joint : columns) J.col(6 + static_cast<Eigen::Index>(joint)) = base_J_frame.col(column++);
  return J;
}

// The bias acceleration of a frame in base axes. Added to J (base_acceleration, qdd), it gives the angular acceleration
// of the frame (rad/s^2) and the acceleration of its origin (m/s^2) in the world. J is jacobian_with_base,
// base_Jd_qd_frame the generated product of that name; the acceleration of the base is spatial, as forward dynamics
// returns it, and gravity is not included.
template <class Scalar, class Jacobian, class Velocities>
Eigen::Matrix<Scalar, 6, 1> bias_acceleration_with_base(
    const typename BasicBasePose<Scalar>::Matrix4& base_X_frame,
    const Eigen::MatrixBase<Jacobian>& J,
    const Eigen::Matrix<Scalar, 6, 1>& base_Jd_qd_frame,
    const BasicTwist<Scalar>& base_velocity,
    const Eigen::MatrixBase<Velocities>& qd) noexcept {
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  const Vector3 origin = base_X_frame.template topRightCorner<3, 1>();
  const Vector3 w = base_velocity.angular(), v = base_velocity.linear();
  const Eigen::Matrix<Scalar, 6, 1> relative = J.template rightCols<Jacobian::ColsAtCompileTime - 6>() * qd;
  // Centripetal and Coriolis acceleration in the moving base (Siciliano et al., Robotics, 2009, 7.2.1).
  const Vector3 linear = relative.template tail<3>();
  Eigen::Matrix<Scalar, 6, 1> bias = base_Jd_qd_frame;
  bias.template head<3>() += w.cross(Vector3(relative.template head<3>()));
  bias.template tail<3>() += w.cross(v + w.cross(origin) + Scalar(2) * linear);
  return bias;
}

// The angular and the linear rows of a matrix in other axes: in world axes with R = pose.rotation(), in axes of a frame
// with the transpose of the rotation in base_X_frame. For Jacobians and biases of frames, and for the centroidal
// momentum matrix and its bias. A rotated bias needs no further term, because biases are rates in an inertial frame.
template <class Scalar, int kColumns>
Matrix<Scalar, 6, kColumns> rows_in_axes(const Matrix<Scalar, 3, 3>& R, const Matrix<Scalar, 6, kColumns>& J) noexcept {
  Matrix<Scalar, 6, kColumns> result;
  result.template topRows<3>() = R * J.template topRows<3>();
  result.template bottomRows<3>() = R * J.template bottomRows<3>();
  return result;
}

// The same for matrices in another storage order, and for expressions.
template <class Rotation, class Rows>
Matrix<typename Rows::Scalar, 6, Rows::ColsAtCompileTime> rows_in_axes(
    const Eigen::MatrixBase<Rotation>& R,
    const Eigen::MatrixBase<Rows>& J) noexcept {
  return rows_in_axes<typename Rows::Scalar, Rows::ColsAtCompileTime>(R, J);
}

// A force (N) at a point (m), both in base coordinates, as the external wrench on a link: about the origin of the link
// and in its coordinates, for the functions that take external wrenches. base_X_link is that of the link's own frame.
template <class Scalar>
BasicWrench<Scalar> wrench_on_link(
    const typename BasicBasePose<Scalar>::Matrix4& base_X_link,
    const Eigen::Matrix<Scalar, 3, 1>& point,
    const Eigen::Matrix<Scalar, 3, 1>& force) noexcept {
  const Matrix<Scalar, 3, 3> link_R_base = base_X_link.template topLeftCorner<3, 3>().transpose();
  const Eigen::Matrix<Scalar, 3, 1> arm = point - base_X_link.template topRightCorner<3, 1>();
  return BasicWrench<Scalar>(link_R_base * arm.cross(force), link_R_base * force);
}

}  // namespace robcogen
