// Pose of a floating base in the world: construction, access, integration and differences.
//
//     BasePose pose = BasePose::from_quaternion_wxyz(w, x, y, z, position);
//     auto motion = quadruped::forward_dynamics(q, qd, tau, base_velocity, gravity_in_base(pose));
//     pose = integrate(pose, base_velocity, dt);
//
// Velocities and accelerations of the base are in base coordinates, angular first, as everywhere. Nothing allocates or
// throws. A quaternion of zeros and a matrix that is not a rotation give an orientation of NaN.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "robcogen/matrix.h"
#include "robcogen/rigid_exponential.h"
#include "robcogen/spatial.h"

namespace robcogen {

// Maps base coordinates to world coordinates. The z axis of the world points up unless gravity is given otherwise.
//
// Libraries disagree on the order of a quaternion's elements, so the name of each function says it: w x y z, or
// x y z w. Both signs of a quaternion represent the same orientation. The quaternion is kept at unit length, in plain
// scalars, so a pose can be stored anywhere.
template <class ScalarType>
class BasicBasePose {
 public:
  using Scalar = ScalarType;
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  using Vector4 = Eigen::Matrix<Scalar, 4, 1>;
  using Matrix3 = Matrix<Scalar, 3, 3>;
  using Matrix4 = Matrix<Scalar, 4, 4>;
  using Matrix6 = Matrix<Scalar, 6, 6>;
  using Quaternion = Eigen::Quaternion<Scalar>;

  // The base frame coincides with that of the world.
  constexpr BasicBasePose() = default;

  // The quaternion may have any length but zero. The position (m) is that of the base origin, in world axes.
  static BasicBasePose from_quaternion_wxyz(
      Scalar w,
      Scalar x,
      Scalar y,
      Scalar z,
      const Vector3& position = Vector3::Zero()) noexcept {
    return BasicBasePose(Vector4(w, x, y, z), position);
  }
  static BasicBasePose from_quaternion_xyzw(
      Scalar x,
      Scalar y,
      Scalar z,
      Scalar w,
      const Vector3& position = Vector3::Zero()) noexcept {
    return BasicBasePose(Vector4(w, x, y, z), position);
  }
  static BasicBasePose from_quaternion(const Quaternion& q, const Vector3& position = Vector3::Zero()) noexcept {
    return BasicBasePose(Vector4(q.w(), q.x(), q.y(), q.z()), position);
  }

  // R maps base axes to world axes; its columns are the axes of the base. Its elements may be rounded to four digits.
  static BasicBasePose from_rotation(const Matrix3& R, const Vector3& position = Vector3::Zero()) noexcept {
    const Matrix3 gram = R.transpose() * R;
    const Scalar deviation = (gram - Matrix3::Identity()).cwiseAbs().maxCoeff();
    // A NaN fails as well.
    const bool is_rotation = deviation < Scalar(kRotationTolerance) && R.determinant() > Scalar(0);
    if (!is_rotation) return from_quaternion_wxyz(Scalar(0), Scalar(0), Scalar(0), Scalar(0), position);
    return from_quaternion(Quaternion(R), position);
  }

  // Roll, pitch, yaw (rad) as in URDF and ROS: R = Rz(yaw) Ry(pitch) Rx(roll), turns about the fixed axes x, y, z of
  // the world, in this order.
  static BasicBasePose from_rpy(
      Scalar roll,
      Scalar pitch,
      Scalar yaw,
      const Vector3& position = Vector3::Zero()) noexcept {
    using AngleAxis = Eigen::AngleAxis<Scalar>;
    const Quaternion about_x(AngleAxis(roll, Vector3::UnitX()));
    const Quaternion about_y(AngleAxis(pitch, Vector3::UnitY()));
    const Quaternion about_z(AngleAxis(yaw, Vector3::UnitZ()));
    return from_quaternion(about_z * about_y * about_x, position);
  }

  Quaternion quaternion() const noexcept { return Quaternion(elements_[0], elements_[1], elements_[2], elements_[3]); }
  Vector4 quaternion_wxyz() const noexcept { return Vector4(elements_[0], elements_[1], elements_[2], elements_[3]); }
  Vector4 quaternion_xyzw() const noexcept { return Vector4(elements_[1], elements_[2], elements_[3], elements_[0]); }
  Matrix3 rotation() const noexcept { return quaternion().toRotationMatrix(); }
  Vector3 position() const noexcept { return Vector3(elements_[4], elements_[5], elements_[6]); }

  // The pose as kernels take it: w, x, y, z of the quaternion, then the position.
  const Scalar* data() const noexcept { return elements_; }

  // world_X_base. Multiplied by a homogeneous transform base_X_frame of the robot, it gives the pose of that frame in
  // the world.
  Matrix4 homogeneous() const noexcept {
    Matrix4 X = Matrix4::Identity();
    X.template topLeftCorner<3, 3>() = rotation();
    X.template topRightCorner<3, 1>() = position();
    return X;
  }

  // world_X_base for twists and spatial accelerations (Featherstone 2008, sec. 2.8).
  Matrix6 motion_transform() const noexcept {
    const Matrix3 R = rotation();
    Matrix6 X = Matrix6::Zero();
    X.template topLeftCorner<3, 3>() = R;
    X.template bottomRightCorner<3, 3>() = R;
    X.template bottomLeftCorner<3, 3>() = exponential::cross_matrix<Scalar>(position()) * R;
    return X;
  }

  // Change the axes of a vector: from base to world axes, and from world to base axes.
  Vector3 to_world_axes(const Vector3& v) const noexcept { return quaternion() * v; }
  Vector3 to_base_axes(const Vector3& v) const noexcept { return quaternion().conjugate() * v; }

 private:
  // Bound of the elements of R^T R - 1: far above the rounding of printed matrices, far below a mistake.
  static constexpr double kRotationTolerance = 1e-3;

  BasicBasePose(const Vector4& wxyz, const Vector3& position) noexcept {
    using std::sqrt;
    // Eigen's normalize() would leave zeros as they are, and the rotation matrix would be the identity.
    Eigen::Map<Vector4> unit(elements_);
    unit = wxyz / sqrt(wxyz.squaredNorm());
    Eigen::Map<Vector3> origin(elements_ + 4);
    origin = position;
  }

  Scalar elements_[7] = {Scalar(1), Scalar(0), Scalar(0), Scalar(0), Scalar(0), Scalar(0), Scalar(0)};
};

using BasePose = BasicBasePose<double>;

// Gravity in base coordinates, as functions of a floating-base robot take it. Gravity in world axes is (0, 0, -9.81)
// m/s^2 unless given.
template <class Scalar>
BasicGravity<Scalar> gravity_in_base(
    const BasicBasePose<Scalar>& pose,
    const BasicGravity<Scalar>& gravity_in_world = BasicGravity<Scalar>::standard()) noexcept {
  return BasicGravity<Scalar>(pose.to_base_axes(gravity_in_world.vector()));
}

// The pose after the base has moved with this constant twist for dt (s): an exact screw motion. The quaternion keeps
// unit length, however many steps follow one another.
template <class Scalar>
BasicBasePose<Scalar> integrate(
    const BasicBasePose<Scalar>& pose,
    const BasicTwist<Scalar>& base_velocity,
    typename BasicBasePose<Scalar>::Scalar dt) noexcept {
  const Eigen::Matrix<Scalar, 3, 1> turn = dt * base_velocity.angular(), shift = dt * base_velocity.linear();
  return BasicBasePose<Scalar>::from_quaternion(
      pose.quaternion() * exponential::quaternion<Scalar>(turn),
      pose.position() + pose.to_world_axes(exponential::displacement<Scalar>(turn, shift)));
}

// The constant twist that leads from one pose to the other in one second, with a rotation of at most half a turn:
// integrate(from, difference(from, to), 1) is `to`. For exactly half a turn, both senses of rotation are right.
template <class Scalar>
BasicTwist<Scalar> difference(const BasicBasePose<Scalar>& from, const BasicBasePose<Scalar>& to) noexcept {
  const Eigen::Matrix<Scalar, 3, 1> turn =
      exponential::rotation_vector<Scalar>(from.quaternion().conjugate() * to.quaternion());
  const Eigen::Matrix<Scalar, 3, 1> shift = from.to_base_axes(to.position() - from.position());
  return BasicTwist<Scalar>(turn, exponential::shift_of_displacement<Scalar>(turn, shift));
}

// Derivatives by a pose are with respect to small changes d, which are twists in its own base coordinates: the pose
// becomes integrate(pose, d, 1).
template <class Scalar>
struct ROBCOGEN_ALIGNED IntegrateDerivatives {
  Matrix<Scalar, 6, 6> d_pose;
  Matrix<Scalar, 6, 6> d_base_velocity;
  BasicTwist<Scalar> d_dt;
};

// Derivatives of integrate(pose, base_velocity, dt), which do not depend on the pose.
template <class Scalar>
IntegrateDerivatives<Scalar> integrate_derivatives(
    const BasicTwist<Scalar>& base_velocity,
    typename BasicBasePose<Scalar>::Scalar dt) noexcept {
  return {
      integrate(BasicBasePose<Scalar>(), -base_velocity, dt).motion_transform(),
      dt * exponential::right_jacobian<Scalar>(dt * base_velocity.angular(), dt * base_velocity.linear()),
      base_velocity};
}

template <class Scalar>
struct ROBCOGEN_ALIGNED DifferenceDerivatives {
  Matrix<Scalar, 6, 6> d_from;
  Matrix<Scalar, 6, 6> d_to;
};

// Derivatives of difference(from, to). Like it, they jump where the rotation passes half a turn.
template <class Scalar>
DifferenceDerivatives<Scalar> difference_derivatives(
    const BasicBasePose<Scalar>& from,
    const BasicBasePose<Scalar>& to) noexcept {
  const BasicTwist<Scalar> d = difference(from, to);
  const BasicTwist<Scalar> back = -d;
  return {
      -exponential::inverse_right_jacobian<Scalar>(back.angular(), back.linear()),
      exponential::inverse_right_jacobian<Scalar>(d.angular(), d.linear())};
}

// Angular acceleration of the base (rad/s^2), then the acceleration of its origin (m/s^2), which is the second time
// derivative of the position. Both are in base axes. An accelerometer at the origin measures the latter minus gravity.
template <class Scalar>
class BasicClassicalAcceleration : public SpatialVector<BasicClassicalAcceleration<Scalar>, Scalar> {
 public:
  using SpatialVector<BasicClassicalAcceleration<Scalar>, Scalar>::SpatialVector;
};

using ClassicalAcceleration = BasicClassicalAcceleration<double>;

// Classical and spatial acceleration differ by angular velocity x linear velocity (Featherstone 2008, eq. 2.48).
template <class Scalar>
BasicClassicalAcceleration<Scalar> classical_from_spatial(
    const BasicSpatialAcceleration<Scalar>& acceleration,
    const BasicTwist<Scalar>& velocity) noexcept {
  return BasicClassicalAcceleration<Scalar>(
      acceleration.angular(), acceleration.linear() + velocity.angular().cross(velocity.linear()));
}

template <class Scalar>
BasicSpatialAcceleration<Scalar> spatial_from_classical(
    const BasicClassicalAcceleration<Scalar>& acceleration,
    const BasicTwist<Scalar>& velocity) noexcept {
  return BasicSpatialAcceleration<Scalar>(
      acceleration.angular(), acceleration.linear() - velocity.angular().cross(velocity.linear()));
}

}  // namespace robcogen
