// Checks of a compiled robot's transforms and Jacobians, by the tables that its reflection lists them in.
//
// Each function records the errors of one sample.
#pragma once

#include "robcogen/reference/checks.h"
#include "robcogen/reference/samples.h"

namespace robcogen::reference {

inline constexpr Tolerance kTransform{
    "kTransform", 1e-13, "rounding of a product of rotations, relative to the lengths"};
inline constexpr Tolerance kJacobian{"kJacobian", 1e-11, "rounding of a product of rotations, twice"};

// The three forms of one compiled transform.
struct TransformForms {
  Matrix4<double> homogeneous;
  Matrix6<double> motion;
  Matrix6<double> force;
};

inline TransformForms evaluate(const reflection::Transform& transform, const VectorX<double>& q) {
  TransformForms result;
  transform.homogeneous(q.data(), result.homogeneous.data());
  transform.motion(q.data(), result.motion.data());
  transform.force(q.data(), result.force.data());
  return result;
}

// Relative to the lengths in the matrix, and to one, which its rotation has.
template <class Actual, class Wanted>
Real transform_error(const Actual& actual, const Wanted& expected) {
  const auto magnitude = expected.cwiseAbs().eval();
  using Matrix = std::decay_t<decltype(magnitude)>;
  using Value = typename Matrix::Scalar;
  return relative_error(actual, expected, Matrix::Constant(std::max(Value(1), magnitude.maxCoeff())));
}

inline TransformForms operator*(const TransformForms& a, const TransformForms& b) {
  return {a.homogeneous * b.homogeneous, a.motion * b.motion, a.force * b.force};
}

// left_X_middle * middle_X_right = left_X_right wherever all three are in the table, and inverse pairs.
inline void check_composition(const Robot& robot, const std::vector<TransformForms>& all, int sample, Checks& checks) {
  const TransformForms identity{Matrix4<double>::Identity(), Matrix6<double>::Identity(), Matrix6<double>::Identity()};
  const auto& table = robot.transforms;
  for (int a = 0; a < table.size; ++a) {
    for (int b = 0; b < table.size; ++b) {
      if (table[a].right != table[b].left) continue;
      const TransformForms& A = all[static_cast<std::size_t>(a)];
      const TransformForms& B = all[static_cast<std::size_t>(b)];
      const auto compare = [&](const char* name, const TransformForms& expected) {
        const TransformForms product = A * B;
        const Real lengths = std::max(1.0, A.motion.cwiseAbs().maxCoeff() * B.motion.cwiseAbs().maxCoeff());
        const Real error = std::max(
            {transform_error(product.homogeneous, expected.homogeneous),
             transform_error(product.motion, expected.motion), transform_error(product.force, expected.force)});
        checks.record(name, kTransform, error / lengths, sample);
      };
      if (table[a].left == table[b].right) compare("P5: inverse pairs", identity);
      for (int c = 0; c < table.size; ++c) {
        if (table[c].left == table[a].left && table[c].right == table[b].right)
          compare("P5: composition", all[static_cast<std::size_t>(c)]);
      }
    }
  }
}

inline void check_transforms(const Robot& robot, const Sample& s, int sample, Checks& checks) {
  const VectorX<Real> q = s.motion.q.cast<Real>();
  std::vector<TransformForms> all;
  for (const reflection::Transform& t : robot.transforms) {
    const TransformForms& X = all.emplace_back(evaluate(t, s.motion.q));
    const Matrix4<Real> expected = transform(robot, q, t.left, t.right);
    checks.record("transforms::homogeneous", kTransform, transform_error(X.homogeneous, expected), sample);
    checks.record("transforms::motion", kTransform, transform_error(X.motion, motion_form(expected)), sample);
    checks.record("transforms::force", kTransform, transform_error(X.force, force_form(expected)), sample);
    checks.record(
        "P5: motion form of the homogeneous one", kTransform, transform_error(X.motion, motion_form(X.homogeneous)),
        sample);
    const Matrix6<double> product = X.force.transpose() * X.motion;
    const Real lengths = std::max(1.0, std::pow(X.motion.cwiseAbs().maxCoeff(), 2));
    checks.record(
        "P5: force = inverse transpose of motion", kTransform,
        transform_error(product, Matrix6<double>::Identity().eval()) / lengths, sample);
  }
  check_composition(robot, all, sample, checks);
}

// Twist of `right` with respect to `left` at the velocity qd, in coordinates of `left`: the pose's rate by a complex
// step, exact to rounding.
inline Vector6<double> frame_velocity(
    const Robot& robot,
    const VectorX<double>& q,
    const VectorX<double>& qd,
    int left,
    int right) {
  using Complex = std::complex<double>;
  const double step = 1e-30;
  VectorX<Complex> moved(q.size());
  moved.real() = q;
  moved.imag() = step * qd;
  const Matrix4<Complex> pose = transform(robot, moved, left, right);
  const Matrix4<double> X = pose.real();
  const Matrix4<double> rate = pose.imag() / step;
  Vector6<double> velocity;
  velocity << axis_of<double>(rotation_of(rate) * rotation_of(X).transpose()), origin_of(rate);
  return velocity;
}

inline void check_jacobians(const Robot& robot, const Sample& s, int sample, Checks& checks) {
  const VectorX<Real> q = s.motion.q.cast<Real>();
  for (const reflection::Jacobian& what : robot.jacobians) {
    Matrix6X<double> J(6, what.column_count);
    what.kernel(s.motion.q.data(), J.data());
    const Matrix6X<Real> expected = jacobian(robot, q, what);
    const Real length = J.size() == 0 ? Real(1) : std::max(Real(1), expected.cwiseAbs().maxCoeff());
    const Matrix6X<Real> lengths = Matrix6X<Real>::Constant(6, what.column_count, length);
    checks.record("jacobians", kJacobian, relative_error(J, expected, lengths), sample);

    // All joints move: J has to have a column for every one that has a part in it.
    VectorX<double> rates(what.column_count);
    for (int k = 0; k < what.column_count; ++k) rates(k) = s.motion.qd(what.columns[k]);
    const Vector6<double> product = J * rates;
    const Vector6<Real> terms = Vector6<Real>::Constant(length * std::max(1.0, s.motion.qd.cwiseAbs().sum()));
    checks.record(
        "P4: J qd = velocity", kJacobian,
        relative_error(product, frame_velocity(robot, s.motion.q, s.motion.qd, what.left, what.right), terms), sample);
  }
}

}  // namespace robcogen::reference
