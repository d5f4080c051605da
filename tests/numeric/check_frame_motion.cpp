#include "check_frame_motion.h"

#include <algorithm>

namespace robcogen::numeric {
namespace {

using reference::Case;
using reference::Matrix;
using reference::Real;
using reference::Vector;

// The columns of the joints that `what` lists, in axes of its left frame.
Matrix<Real> in_left(const Case& c, const Vector<Real>& q, const reflection::Jacobian& what) {
  return reference::jacobian(c.robot, q, what);
}

// The same velocity in axes of the right frame.
Matrix<Real> in_target(const Case& c, const Vector<Real>& q, const reflection::Jacobian& what) {
  const Matrix<Real> R = transpose(reference::rotation_of(reference::transform(c.robot, q, what.left, what.right)));
  const Matrix<Real> J = in_left(c, q, what);
  return stacked(R * J.head(3), R * J.tail(3));
}

// The twist about the left origin: the velocity there is v + p x w.
Matrix<Real> spatial(const Case& c, const Vector<Real>& q, const reflection::Jacobian& what) {
  const Vector<Real> p = reference::origin_of(reference::transform(c.robot, q, what.left, what.right));
  const Matrix<Real> J = in_left(c, q, what);
  return stacked(J.head(3), J.tail(3) + reference::skew(p) * J.head(3));
}

// The values of the chain's joints.
Vector<Real> of_chain(const Vector<Real>& all, const reflection::Jacobian& what) {
  Vector<Real> values(what.column_count);
  for (int k = 0; k < what.column_count; ++k) values(k) = all(what.columns[k]);
  return values;
}

template <class Function>
Matrix<Real> rate_of(const Function& f, Real step) {
  return 1 / (12 * step) * (Real(8) * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step)));
}

void check_pair(
    const InterpretedRobot& robot,
    const Case& c,
    const reflection::Jacobian& what,
    reference::Checks& checks) {
  const std::string left = c.robot.frames[what.left].name, right = c.robot.frames[what.right].name;
  const reference::Motion<double>& given = c.sample.motion;
  const symbolic::Arrays<double> inputs{
      {"q", given.q.values()}, {"qd", given.qd.values()}, {"qdd", given.qdd.values()}};
  const auto run = [&](const std::string& prefix, const std::string& letter, const char* output) {
    const std::vector<double> values = robot.run(prefix + left + "_" + letter + "_" + right, {}, inputs).at(output);
    Matrix<Real> m(6, static_cast<int>(values.size()) / 6);
    std::copy(values.begin(), values.end(), m.data());
    return m;
  };
  const auto at = [&](Real t) -> Vector<Real> { return c.motion.q + t * c.motion.qd; };
  const auto accelerated = [&](Real t) -> Vector<Real> { return at(t) + t * t / 2 * c.motion.qdd; };
  const Vector<Real> rates = of_chain(c.motion.qd, what), accelerations = of_chain(c.motion.qdd, what);
  Real speed = 1;
  for (int k = 0; k < rates.rows(); ++k) speed += std::abs(rates(k));
  const Real step = 1e-4L / speed;  // s: the chain turns by 1e-4 rad at most
  const Matrix<Real> about_origin = spatial(c, c.motion.q, what);
  const Real lengths = std::max({Real(1), largest(about_origin), largest(in_left(c, c.motion.q, what))});
  const auto compare = [&](const char* name, const reference::Tolerance& tolerance, const Matrix<Real>& found,
                           const Matrix<Real>& expected,
                           Real scale) { checks.record(name, tolerance, largest(found - expected) / scale, c.index); };

  compare(
      "jacobians::in_target", reference::kJacobian, run("in_target_", "J", "J"), in_target(c, c.motion.q, what),
      lengths);
  compare("jacobians::spatial", reference::kJacobian, run("spatial_", "J", "J"), about_origin, lengths);
  const Matrix<Real> change = rate_of([&](Real t) { return in_left(c, at(t), what); }, step);
  compare("Jacobian derivative", kFrameRate, run("", "Jd", "Jd"), change, lengths * speed);
  compare(
      "Jacobian derivative times velocity", kFrameRate, run("", "Jd_qd", "a"), change * rates, lengths * speed * speed);
  compare("velocities", reference::kJacobian, run("", "V", "V"), about_origin * rates, lengths * speed);
  const auto twist = [&](Real t) { return spatial(c, accelerated(t), what) * (rates + t * accelerations); };
  const Real hurry = speed * speed + reference::largest(accelerations);
  compare("accelerations", kFrameRate, run("", "A", "A"), rate_of(twist, step), lengths * hurry);
}

}  // namespace

void check_frame_motions(const InterpretedRobot& robot, const Case& c, reference::Checks& checks) {
  for (int i = 0; i < c.robot.jacobians.size; ++i) check_pair(robot, c, c.robot.jacobians[i], checks);
}

}  // namespace robcogen::numeric
