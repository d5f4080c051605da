#include "algorithm/newton_euler.h"

#include <algorithm>
#include <limits>

namespace robcogen::algorithm {
namespace {

// Which expression of the moment n = axial(U S): three ways to write the same vector.
enum class MomentForm {
  products,   // all components from products of U and S
  z_by_rate,  // z component as wd_z I_zz + w_x w_y (S_xx - S_yy) + …
  euler,      // I wd + w x I w
};

Vector3 moment_about_origin(const MassProperties& m, const AngularState& state, MomentForm form) {
  const Matrix3& s = m.pseudo_inertia;
  const auto& [w, wd] = state;
  const auto u = [&](std::size_t row, std::size_t column) { return state.u(row, column); };
  if (form == MomentForm::euler) {
    const Matrix3 inertia = inertia_tensor(m);
    const Vector3 euler = multiply(inertia, wd);
    return euler + cross(w, multiply(inertia, w));
  }
  const Expression xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
  // One term after the other: the order of making is the same with every compiler.
  Expression nx = u(2, 0) * s[0][1];
  nx += u(2, 1) * s[1][1];
  nx -= u(1, 2) * s[2][2];
  nx += (zz - yy) * s[1][2];
  nx -= u(1, 0) * s[0][2];
  Expression ny = (xx - zz) * s[0][2];
  ny += u(0, 1) * s[1][2];
  ny += u(0, 2) * s[2][2];
  ny -= u(2, 0) * s[0][0];
  ny -= u(2, 1) * s[0][1];
  Expression nz;
  if (form == MomentForm::products) {
    nz = u(1, 0) * s[0][0];
    nz -= u(0, 1) * s[1][1];
  } else {
    nz = wd[2] * (s[0][0] + s[1][1]);
    const Expression product = w[0] * w[1];
    nz += product * (s[0][0] - s[1][1]);
  }
  nz += (yy - xx) * s[0][1];
  nz += u(1, 2) * s[0][2];
  nz -= u(0, 2) * s[1][2];
  return {nx, ny, nz};
}

// S about a point displaced by -p: S + h2 p' + p h2' with h2 = h + m p / 2; and h + m p.
MassProperties displaced(const MassProperties& m, const Vector3& p) {
  if (is_zero(p)) return m;
  MassProperties result = m;
  Vector3 half;
  for (std::size_t i = 0; i < 3; ++i) {
    const Expression mp = m.mass * p[i];
    result.first_moment[i] = m.first_moment[i] + mp;
    half[i] = m.first_moment[i] + 0.5 * mp;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      result.pseudo_inertia[i][j] += i == j ? (2.0 * p[i]) * half[i] : sum_of_products(half[i], p[j], p[i], half[j]);
      result.pseudo_inertia[j][i] = result.pseudo_inertia[i][j];
    }
  }
  return result;
}

}  // namespace

MassProperties mass_properties(Trace& trace, const model::Link& link) {
  MassProperties result;
  if (!link.inertia) return result;
  const model::RigidBodyInertia body = model::in_link_frame(*link.inertia);
  // S = tr(I) / 2 - I; products of inertia are the elements of S themselves.
  const model::Quantity half(Number::rational(1, 2));
  const model::Quantity trace_half = half * (body.ixx + body.iyy + body.izz);
  const std::array<std::array<model::Quantity, 3>, 3> s = {
      {{trace_half - body.ixx, body.ixy, body.ixz},
       {body.ixy, trace_half - body.iyy, body.iyz},
       {body.ixz, body.iyz, trace_half - body.izz}}};
  result.mass = trace.lift(body.mass);
  result.first_moment = trace.lift(body.first_moment);
  for (std::size_t i = 0; i < 3; ++i) result.pseudo_inertia[i] = trace.lift(s[i]);
  return result;
}

Matrix3 inertia_tensor(const MassProperties& m) {
  const Matrix3& s = m.pseudo_inertia;
  return {
      {Vector3{s[1][1] + s[2][2], -s[0][1], -s[0][2]}, Vector3{-s[0][1], s[0][0] + s[2][2], -s[1][2]},
       Vector3{-s[0][2], -s[1][2], s[0][0] + s[1][1]}}};
}

MassProperties operator+(const MassProperties& a, const MassProperties& b) {
  return {a.mass + b.mass, a.first_moment + b.first_moment, a.pseudo_inertia + b.pseudo_inertia};
}

MassProperties to_parent(const Pose& pose, const MassProperties& child) {
  const MassProperties slid = displaced(child, {Expression(), Expression(), pose.slide});
  const MassProperties turned = {
      slid.mass, to_parent(pose.rotation, slid.first_moment), symmetric_to_parent(pose.rotation, slid.pseudo_inertia)};
  return displaced(turned, pose.offset);
}

// Off the diagonal w_r w_c plus or minus the remaining component of wd; on it minus the squares of the others.
Expression AngularState::u(std::size_t row, std::size_t column) const {
  if (row == column) {
    const std::size_t i = (row + 1) % 3, j = (row + 2) % 3;
    const Expression &a = w[std::min(i, j)], &b = w[std::max(i, j)];
    return -sum_of_products(a, a, b, b);
  }
  const std::size_t other = 3 - row - column;
  const Expression product = w[row] * w[column];
  return column == (row + 1) % 3 ? product - wd[other] : product + wd[other];
}

Vector3 multiply_u(const AngularState& state, const Vector3& v) {
  Vector3 result;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      if (!v[c].is_zero()) result[r] += state.u(r, c) * v[c];
  return result;
}

LinkMotion child_motion(
    const Pose& pose,
    bool revolute,
    const LinkMotion& parent,
    const Expression& qd,
    const Expression& qdd) {
  Vector3 w = to_child(pose.rotation, parent.angular.w);
  Vector3 wd = to_child(pose.rotation, parent.angular.wd);
  Vector3 a = to_child(pose.rotation, parent.a + multiply_u(parent.angular, pose.offset));
  if (revolute) {
    wd += Vector3{w[1] * qd, -(w[0] * qd), qdd};
    w[2] += qd;
  } else {
    const Expression twice = qd + qd;
    a += Vector3{w[1] * twice, -(w[0] * twice), qdd};
  }
  LinkMotion child{{w, wd}, a};
  if (!pose.slide.is_zero())
    for (std::size_t i = 0; i < 3; ++i) child.a[i] += pose.slide * child.angular.u(i, 2);
  return child;
}

Spatial link_wrench(Trace& trace, const MassProperties& m, const LinkMotion& motion, bool only_z_moment) {
  Spatial wrench;
  if (!only_z_moment) {
    wrench.linear = multiply_u(motion.angular, m.first_moment);
    if (!m.mass.is_zero()) wrench.linear += m.mass * motion.a;
  }
  const auto moment = [&](MomentForm form) {
    Vector3 n = moment_about_origin(m, motion.angular, form);
    n += cross(m.first_moment, motion.a);
    return only_z_moment ? Vector3{Expression(), Expression(), n[2]} : n;
  };
  MomentForm best = MomentForm::z_by_rate;
  int least = std::numeric_limits<int>::max();
  for (MomentForm form : {MomentForm::z_by_rate, MomentForm::products, MomentForm::euler}) {
    const std::size_t before = trace.graph.mark();
    moment(form);
    const int cost = trace.graph.cost_since(before);
    trace.graph.rollback(before);
    if (cost < least) {
      least = cost;
      best = form;
    }
  }
  wrench.angular = moment(best);
  return wrench;
}

Spatial to_parent(const Pose& pose, const Spatial& wrench) {
  Vector3 n = wrench.angular;
  if (!pose.slide.is_zero()) {
    n[0] -= pose.slide * wrench.linear[1];
    n[1] += pose.slide * wrench.linear[0];
  }
  const Vector3 force = to_parent(pose.rotation, wrench.linear);
  const Vector3 moment = to_parent(pose.rotation, n);
  return {moment + cross(pose.offset, force), force};
}

Spatial to_child(const Pose& pose, const Spatial& motion) {
  Spatial result;
  result.angular = to_child(pose.rotation, motion.angular);
  result.linear = to_child(pose.rotation, motion.linear + cross(motion.angular, pose.offset));
  if (!pose.slide.is_zero()) {
    result.linear[0] += pose.slide * result.angular[1];
    result.linear[1] -= pose.slide * result.angular[0];
  }
  return result;
}

Spatial child_twist(const Pose& pose, bool revolute, const Spatial& parent, const Expression& qd) {
  Spatial twist = to_child(pose, parent);
  (revolute ? twist.angular : twist.linear)[2] += qd;
  return twist;
}

}  // namespace robcogen::algorithm
