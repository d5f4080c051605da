// Random poses and twists, and exponentials that share no formula with the runtime.
#pragma once

#include <random>

#include "robcogen/pose.h"
#include "robcogen/reference/samples.h"

namespace robcogen::test {

template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> random_vector(std::mt19937_64& engine) {
  Eigen::Matrix<Scalar, 3, 1> v;
  for (Scalar& x : v) x = static_cast<Scalar>(reference::uniform(engine, 1.0));
  return v;
}

template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> random_direction(std::mt19937_64& engine) {
  return random_vector<Scalar>(engine).normalized();
}

template <class Scalar>
BasicBasePose<Scalar> random_pose(std::mt19937_64& engine) {
  const auto v = random_vector<Scalar>(engine);
  const auto w = static_cast<Scalar>(reference::uniform(engine, 1.0));
  return BasicBasePose<Scalar>::from_quaternion_wxyz(w, v.x(), v.y(), v.z(), random_vector<Scalar>(engine));
}

using Matrix4 = Eigen::Matrix<long double, 4, 4>;

inline Matrix4 exact_homogeneous(const BasePose& pose) {
  const Eigen::Matrix<long double, 4, 1> q = pose.quaternion_wxyz().cast<long double>().normalized();
  const long double w = q[0], x = q[1], y = q[2], z = q[3];
  Matrix4 X = Matrix4::Identity();
  X.topLeftCorner<3, 3>() << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),                         //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  X.topRightCorner<3, 1>() = pose.position().cast<long double>();
  return X;
}

// The power series of the matrix exponential for the argument divided by 2^10; the result is squared ten times.
inline Matrix4 exact_exponential(const Twist& twist) {
  constexpr int kHalvings = 10, kTerms = 20;
  const Eigen::Matrix<long double, 6, 1> t = twist.vector().cast<long double>() / (1 << kHalvings);
  Matrix4 A;
  A << 0, -t[2], t[1], t[3], t[2], 0, -t[0], t[4], -t[1], t[0], 0, t[5], 0, 0, 0, 0;
  Matrix4 result = Matrix4::Identity(), term = result;
  for (int k = 1; k <= kTerms; ++k) {
    term = term * A / k;
    result += term;
  }
  for (int i = 0; i < kHalvings; ++i) result = result * result;
  return result;
}

}  // namespace robcogen::test
