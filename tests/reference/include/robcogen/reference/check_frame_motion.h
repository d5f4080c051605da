// Checks of functions of frame pairs other than transforms and Jacobians, for all that a robot's tables list: Jacobians
// in other reference frames, time derivatives, velocities and accelerations. Each function records the errors of one
// sample.
#pragma once

#include <algorithm>
#include <complex>
#include <set>

#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/check_kinematics.h"
#include "robcogen/reference/loops.h"

namespace robcogen::reference {

using reflection::FrameFunction;
using reflection::FrameQuantity;

inline constexpr Tolerance kFrameMotion{
    "kFrameMotion", 1e-13, "rounding of products of rotations, relative to lengths and powers of the rates"};

// 6 x n, a column for every joint. The scalar may be complex.
template <class Scalar>
Matrix<Scalar> jacobian_in_target(const Robot& robot, const Vector<Scalar>& q, int left, int right) {
  const Matrix<Scalar> right_R_left = transpose(rotation_of(transform(robot, q, left, right)));
  const Matrix<Scalar> J = frame_jacobian(robot, q, left, right);
  return stacked(right_R_left * J.head(3), right_R_left * J.tail(3));
}

// The point that moves with `right` at the origin of `left` has the velocity v + p x w.
template <class Scalar>
Matrix<Scalar> spatial_jacobian(const Robot& robot, const Vector<Scalar>& q, int left, int right) {
  const Matrix<Scalar> J = frame_jacobian(robot, q, left, right);
  return stacked(J.head(3), J.tail(3) + skew(origin_of(transform(robot, q, left, right))) * J.head(3));
}

// The time derivative of f(q, qd), by a complex step: exact to rounding.
template <class Function>
Matrix<Real> rate_of(const Robot& robot, const Function& f, const Motion<Real>& m) {
  using Complex = std::complex<Real>;
  const Real step = 1e-30L;
  const Vector<Complex> q = moved(robot, m.q.cast<Complex>(), Complex(0, step) * m.qd.cast<Complex>());
  const Vector<Complex> qd = m.qd.cast<Complex>() + Complex(0, step) * m.qdd.cast<Complex>();
  const Matrix<Complex> value = f(q, qd);
  return value.mapped([&](const Complex& x) { return x.imag() / step; });
}

// Jacobians have the columns of all joints. `tangent_change` is AtLoops::change_of_tangent for a robot with loops.
inline Matrix<Real> frame_quantity(
    const Robot& robot,
    const Motion<Real>& m,
    FrameQuantity quantity,
    int left,
    int right,
    const Matrix<Real>& tangent_change = {}) {
  const auto derivative = [&] {
    return rate_of(
        robot, [&](const auto& q, const auto&) { return frame_jacobian(robot, q, left, right); }, m);
  };
  const auto twist = [&](const auto& q, const auto& qd) { return spatial_jacobian(robot, q, left, right) * qd; };
  // The contribution of joints that follow through loops in a proportion that changes.
  const auto of_loops = [&](const auto& jacobian) {
    if (m.of_loops.empty()) return Matrix<Real>(6, 1);
    return jacobian(with_free_joints(robot), joint_positions(robot, m.q)) * m.of_loops;
  };
  switch (quantity) {
    case FrameQuantity::jacobian_in_target:
      return jacobian_in_target(robot, m.q, left, right);
    case FrameQuantity::spatial_jacobian:
      return spatial_jacobian(robot, m.q, left, right);
    case FrameQuantity::jacobian_derivative:
      if (tangent_change.empty()) return derivative();
      return derivative() +
             frame_jacobian(with_free_joints(robot), joint_positions(robot, m.q), left, right) * tangent_change;
    case FrameQuantity::frame_bias_acceleration:
      return derivative() * m.qd +
             of_loops([&](const Robot& r, const auto& q) { return frame_jacobian(r, q, left, right); });
    case FrameQuantity::frame_velocity:
      return twist(m.q, m.qd);
    case FrameQuantity::frame_acceleration:
      return rate_of(robot, twist, m) +
             of_loops([&](const Robot& r, const auto& q) { return spatial_jacobian(r, q, left, right); });
  }
  return Matrix<Real>(6, 0);
}

inline const char* name_of(FrameQuantity quantity) {
  switch (quantity) {
    case FrameQuantity::jacobian_in_target:
      return "jacobians::in_target";
    case FrameQuantity::spatial_jacobian:
      return "jacobians::spatial";
    case FrameQuantity::jacobian_derivative:
      return "jacobians: Jd";
    case FrameQuantity::frame_bias_acceleration:
      return "jacobians: Jd_qd";
    case FrameQuantity::frame_velocity:
      return "velocities";
    case FrameQuantity::frame_acceleration:
      return "accelerations";
  }
  return "";
}

// The joints that move one frame with respect to the other, in the robot's order.
inline std::vector<int> joints_between(const Robot& robot, int left, int right) {
  std::vector<int> to_left = supporting_joints(robot, robot.frames[left].link);
  std::vector<int> to_right = supporting_joints(robot, robot.frames[right].link);
  std::sort(to_left.begin(), to_left.end());
  std::sort(to_right.begin(), to_right.end());
  std::vector<int> joints;
  std::set_symmetric_difference(
      to_left.begin(), to_left.end(), to_right.begin(), to_right.end(), std::back_inserter(joints));
  return joints;
}

// The elements of q that move these joints, in order.
inline std::vector<int> coordinates_of(const Robot& robot, const std::vector<int>& joints) {
  std::set<int> coordinates;
  for (const int j : joints)
    for (const Mover& mover : movers_of(robot, j)) coordinates.insert(mover.coordinate);
  return {coordinates.begin(), coordinates.end()};
}

// The size of a quantity's terms. `lengths` is the size of the chain's Jacobians (m, or 1); `rates` and `accelerations`
// are sums over its joints.
inline Real terms_of(FrameQuantity quantity, Real lengths, Real rates, Real accelerations) {
  switch (quantity) {
    case FrameQuantity::jacobian_in_target:
    case FrameQuantity::spatial_jacobian:
      return lengths;
    case FrameQuantity::jacobian_derivative:
    case FrameQuantity::frame_velocity:
      return lengths * rates;
    case FrameQuantity::frame_bias_acceleration:
      return lengths * rates * rates;
    case FrameQuantity::frame_acceleration:
      return lengths * (rates * rates + accelerations);
  }
  return 1;
}

template <class Subject>
void check_frame_motions(const Subject& subject, const Case& c, Checks& checks) {
  Matrix<Real> tangent_change;
  if (c.loops != nullptr && c.robot.frame_functions.size > 0) tangent_change = c.loops->change_of_tangent(c.motion.qd);
  for (int i = 0; i < c.robot.frame_functions.size; ++i) {
    const FrameFunction& f = c.robot.frame_functions[i];
    const std::vector<int> joints = coordinates_of(c.robot, joints_between(c.robot, f.left, f.right));
    Matrix<Real> expected = frame_quantity(c.robot, c.motion, f.quantity, f.left, f.right, tangent_change);
    if (reflection::is_jacobian(f.quantity)) {
      std::vector<int> listed(f.columns, f.columns + f.column_count);
      const Matrix<Real> all = expected;
      expected = Matrix<Real>(6, f.column_count);
      for (int k = 0; k < f.column_count; ++k) expected.set_block(0, k, all.col(f.columns[k]));
      std::sort(listed.begin(), listed.end());
      checks.record("columns: the joints between the frames", kExact, listed == joints ? 0 : 1, c.index);
    }
    Real rates = 1, accelerations = 1;
    for (const int j : joints) {
      rates += std::abs(c.motion.qd(j));
      accelerations += std::abs(c.motion.qdd(j));
    }
    const Real lengths = std::max(
        {Real(1), largest(frame_jacobian(c.robot, c.motion.q, f.left, f.right)),
         largest(spatial_jacobian(c.robot, c.motion.q, f.left, f.right))});
    const Matrix<Real> found = subject.frame_function(i, c.sample.motion).template cast<Real>();
    const Real error = largest(found - expected) / terms_of(f.quantity, lengths, rates, accelerations);
    checks.record(name_of(f.quantity), kFrameMotion, error, c.index);
  }
}

}  // namespace robcogen::reference
