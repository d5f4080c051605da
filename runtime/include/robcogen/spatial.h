// 6D quantities and gravity as distinct types, so that a swapped argument does not compile.
//
// Angular part first, linear part second (Featherstone 2008), SI units. They hold plain scalars, so they can be stored
// anywhere and passed by value, whatever alignment Eigen's vectors have.
#pragma once

#include <Eigen/Core>

#include "robcogen/layout.h"

namespace robcogen {

// Base of the 6D types: access, and the arithmetic of a vector space.
template <class Derived, class Scalar>
class SpatialVector {
 public:
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  using Vector6 = Eigen::Matrix<Scalar, 6, 1>;

  // Zero.
  constexpr SpatialVector() = default;

  template <class Vector>
  explicit SpatialVector(const Eigen::MatrixBase<Vector>& v) {
    Eigen::Map<Vector6> values(values_);
    values = v;
  }

  template <class Angular, class Linear>
  SpatialVector(const Eigen::MatrixBase<Angular>& angular, const Eigen::MatrixBase<Linear>& linear) {
    this->angular() = angular;
    this->linear() = linear;
  }

  // Views of the parts of a variable, to read and write; copies for anything else.
  Eigen::Map<Vector3> angular() & { return Eigen::Map<Vector3>(values_); }
  Eigen::Map<Vector3> linear() & { return Eigen::Map<Vector3>(values_ + 3); }
  Vector3 angular() const& { return Vector3(values_[0], values_[1], values_[2]); }
  Vector3 linear() const& { return Vector3(values_[3], values_[4], values_[5]); }

  Vector6 vector() const { return Eigen::Map<const Vector6>(values_); }

  const Scalar* data() const noexcept { return values_; }
  Scalar* data() noexcept { return values_; }

  friend Derived operator+(const Derived& a, const Derived& b) { return Derived(a.vector() + b.vector()); }
  friend Derived operator-(const Derived& a, const Derived& b) { return Derived(a.vector() - b.vector()); }
  friend Derived operator-(const Derived& a) { return Derived(-a.vector()); }
  friend Derived operator*(const Scalar& s, const Derived& a) { return Derived(s * a.vector()); }
  friend Derived operator*(const Derived& a, const Scalar& s) { return s * a; }
  friend bool operator==(const Derived& a, const Derived& b) { return a.vector() == b.vector(); }
  friend bool operator!=(const Derived& a, const Derived& b) { return !(a == b); }

 private:
  Scalar values_[6] = {};
};

// Velocity of a rigid body: angular velocity (rad/s), then the velocity (m/s) of its point at the origin.
template <class Scalar>
class BasicTwist : public SpatialVector<BasicTwist<Scalar>, Scalar> {
 public:
  using SpatialVector<BasicTwist<Scalar>, Scalar>::SpatialVector;
};

// Time derivative of a twist in fixed coordinates (rad/s^2, m/s^2). Its linear part is not the acceleration of a body
// point: that is linear + angular velocity x linear velocity.
template <class Scalar>
class BasicSpatialAcceleration : public SpatialVector<BasicSpatialAcceleration<Scalar>, Scalar> {
 public:
  using SpatialVector<BasicSpatialAcceleration<Scalar>, Scalar>::SpatialVector;
};

// Moment about the origin (N m), then force (N).
template <class Scalar>
class BasicWrench : public SpatialVector<BasicWrench<Scalar>, Scalar> {
 public:
  using SpatialVector<BasicWrench<Scalar>, Scalar>::SpatialVector;
};

// Acceleration of gravity, m/s^2.
template <class Scalar>
class BasicGravity {
 public:
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

  constexpr explicit BasicGravity(Scalar x, Scalar y, Scalar z) noexcept : values_{x, y, z} {}
  template <class Vector>
  explicit BasicGravity(const Eigen::MatrixBase<Vector>& v) {
    Eigen::Map<Vector3> values(values_);
    values = v;
  }
  // 9.81 m/s^2 along -z.
  static constexpr BasicGravity standard() noexcept { return BasicGravity(Scalar(0), Scalar(0), Scalar(-9.81)); }

  Vector3 vector() const { return Eigen::Map<const Vector3>(values_); }
  constexpr const Scalar* data() const noexcept { return values_; }

 private:
  Scalar values_[3] = {};
};

using Twist = BasicTwist<double>;
using SpatialAcceleration = BasicSpatialAcceleration<double>;
using Wrench = BasicWrench<double>;
using Gravity = BasicGravity<double>;

inline constexpr Gravity kStandardGravity = Gravity::standard();

}  // namespace robcogen
