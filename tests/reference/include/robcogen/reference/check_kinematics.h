// Checks of all transforms and Jacobians that a robot's tables list. Each function records the errors of one sample.
#pragma once

#include "robcogen/reference/check_dynamics.h"
#include "robcogen/reference/composition.h"

namespace robcogen::reference {

inline constexpr Tolerance kJacobian{"kJacobian", 1e-13, "rounding of a product of rotations, twice"};

template <class Subject>
void check_transforms(const Subject& subject, const Case& c, Checks& checks) {
  std::vector<TransformForms> all;
  std::vector<FramePair> pairs;
  for (int i = 0; i < c.robot.transforms.size; ++i) {
    const reflection::Transform& t = c.robot.transforms[i];
    const TransformForms& X = all.emplace_back(subject.transform(i, c.sample.motion.q));
    const Matrix<Real> expected = transform(c.robot, c.motion.q, t.left, t.right);
    const auto record = [&](const char* name, Real error) { checks.record(name, kTransform, error, c.index); };
    record("transforms::homogeneous", transform_error(X.homogeneous, expected));
    record("transforms::motion", transform_error(X.motion, motion_form(expected)));
    record("transforms::force", transform_error(X.force, force_form(expected)));
    check_duality(X, c.index, checks);
    pairs.push_back({t.left, t.right});
  }
  check_composition(pairs, all, c.index, checks);
}

// The twist of `right` with respect to `left` at the velocity qd, in coordinates of `left`: the rate of the pose, by a
// complex step, exact to rounding.
inline Vector<double> frame_velocity(
    const Robot& robot,
    const Vector<double>& q,
    const Vector<double>& qd,
    int left,
    int right) {
  using Complex = std::complex<double>;
  const double step = 1e-30;
  const Vector<Complex> there = moved(robot, q.cast<Complex>(), Complex(0, step) * qd.cast<Complex>());
  const Matrix<Complex> pose = transform(robot, there, left, right);
  const Matrix<double> X = pose.mapped([](const Complex& x) { return x.real(); });
  const Matrix<double> rate = pose.mapped([&](const Complex& x) { return x.imag() / step; });
  return stacked(axis_of(rotation_of(rate) * transpose(rotation_of(X))), origin_of(rate));
}

template <class Subject>
void check_jacobians(const Subject& subject, const Case& c, Checks& checks) {
  const Motion<double>& m = c.sample.motion;
  for (int i = 0; i < c.robot.jacobians.size; ++i) {
    const reflection::Jacobian& what = c.robot.jacobians[i];
    const Matrix<double> J = subject.jacobian(i, m.q);
    const Matrix<Real> expected = jacobian(c.robot, c.motion.q, what);
    checks.record("jacobians", kJacobian, transform_error(J, expected), c.index);

    // All joints move, so J must have a column for every joint that moves the frame.
    Vector<double> rates(what.column_count);
    double speed = 1;
    for (int k = 0; k < what.column_count; ++k) {
      rates(k) = m.qd(what.columns[k]);
      speed += std::abs(rates(k));
    }
    const Real lengths = std::max(Real(1), largest(expected));
    const Real error = largest(J * rates - frame_velocity(c.robot, m.q, m.qd, what.left, what.right));
    checks.record("P4: J qd = velocity", kJacobian, error / (lengths * speed), c.index);
  }
}

}  // namespace robcogen::reference
