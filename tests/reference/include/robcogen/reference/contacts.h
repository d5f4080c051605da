// Contacts of a robot: Jacobians of the contact frames, and the accelerations and wrenches by a dense solve. Rows are
// in the order of the robot's list, angular ones of surfaces first, in base axes.
#pragma once

#include <optional>

#include "robcogen/reference/dynamics.h"

namespace robcogen::reference {

inline int contact_rows(const Robot& robot) {
  int rows = 0;
  for (const reflection::Contact& contact : robot.contacts) rows += contact.is_surface ? 6 : 3;
  return rows;
}

// Expands one value per contact to one value per row.
inline std::vector<double> by_row(const Robot& robot, const std::vector<double>& by_contact) {
  std::vector<double> result;
  for (int c = 0; c < robot.contacts.size; ++c)
    result.insert(result.end(), robot.contacts[c].is_surface ? 6 : 3, by_contact[static_cast<std::size_t>(c)]);
  return result;
}

template <class Scalar>
Vector<Scalar> origin_in_link(const reflection::Frame& frame) {
  return {Scalar(frame.translation[0]), Scalar(frame.translation[1]), Scalar(frame.translation[2])};
}

// Angular velocity of a frame and velocity of its origin, by (base twist, qd), or by qd with a fixed base.
template <class Scalar>
Matrix<Scalar> jacobian_with_base(const Robot& robot, const Vector<Scalar>& q, int frame) {
  const reflection::Frame& f = robot.frames[frame];
  const Matrix<Scalar> J = body_jacobian(robot, link_poses(robot, q), f.link, origin_in_link<Scalar>(f));
  return robot.floating_base ? J : J.block(0, 6, 6, J.cols() - 6);
}

// The rates of these velocities when neither joints nor base accelerate.
template <class Scalar>
Vector<Scalar> bias_with_base(const Robot& robot, Motion<Scalar> motion, int frame) {
  motion.qdd = Vector<Scalar>(motion.qd.rows());
  motion.base_acceleration = Vector<Scalar>(6);
  const reflection::Frame& f = robot.frames[frame];
  const std::vector<LinkMotion<Scalar>> links = link_motions(robot, motion);
  const LinkMotion<Scalar>& link = links[static_cast<std::size_t>(f.link)];
  return stacked(link.angular_acceleration(), link.acceleration(origin_in_link<Scalar>(f)));
}

// Stacks the rows of all contacts. `of_frame` returns six rows for each frame.
template <class Scalar, class OfFrame>
Matrix<Scalar> rows_of_contacts(const Robot& robot, int columns, const OfFrame& of_frame) {
  Matrix<Scalar> all(contact_rows(robot), columns);
  int next = 0;
  for (const reflection::Contact& contact : robot.contacts) {
    const Matrix<Scalar> six = of_frame(contact.frame);
    const int rows = contact.is_surface ? 6 : 3;
    all.set_block(next, 0, six.tail(rows));
    next += rows;
  }
  return all;
}

template <class Scalar>
Matrix<Scalar> contact_jacobian(const Robot& robot, const Vector<Scalar>& q) {
  return rows_of_contacts<Scalar>(robot, (robot.floating_base ? 6 : 0) + robot.dof(), [&](int frame) {
    return jacobian_with_base(robot, q, frame);
  });
}

template <class Scalar>
Vector<Scalar> contact_bias(const Robot& robot, const Motion<Scalar>& motion) {
  return rows_of_contacts<Scalar>(robot, 1, [&](int frame) { return bias_with_base(robot, motion, frame); });
}

// Returns (a, f), the solution of
//     H a - J^T f = forces,     J a + compliance f = wanted,
// over the active rows; f is zero elsewhere. Returns nullopt if the solution in double precision has a relative error
// above `digits`.
inline std::optional<Vector<long double>> solve_contacts(
    const Matrix<long double>& H,
    const Matrix<long double>& J,
    const Vector<long double>& forces,
    const Vector<long double>& wanted,
    const std::vector<double>& active,
    const std::vector<double>& compliance,
    double digits) {
  using Scalar = long double;
  const int n = H.rows();
  std::vector<int> on;
  for (int r = 0; r < J.rows(); ++r)
    if (active[static_cast<std::size_t>(r)] != 0) on.push_back(r);
  const int m = static_cast<int>(on.size());
  Matrix<Scalar> K(n + m, n + m);
  Vector<Scalar> b(n + m);
  K.set_block(0, 0, H);
  b.set_block(0, 0, forces);
  for (int i = 0; i < m; ++i) {
    const int r = on[static_cast<std::size_t>(i)];
    const Matrix<Scalar> row = J.block(r, 0, 1, n);
    K.set_block(n + i, 0, row);
    K.set_block(0, n + i, -transpose(row));
    K(n + i, n + i) = Scalar(compliance[static_cast<std::size_t>(r)]);
    b(n + i) = wanted(r);
  }
  const Vector<Scalar> x = solve(K, b);
  const Vector<Scalar> in_double = solve(K.cast<double>(), b.cast<double>()).cast<Scalar>();
  if (!(largest(in_double - x) <= Scalar(digits) * (1 + largest(x)))) return std::nullopt;
  Vector<Scalar> result(n + J.rows());
  result.set_block(0, 0, x.head(n));
  for (int i = 0; i < m; ++i) result(n + on[static_cast<std::size_t>(i)]) = x(n + i);
  return result;
}

}  // namespace robcogen::reference
