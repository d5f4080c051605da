#include "algorithm/spatial/link_motion.h"

#include "algorithm/spatial/describe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robcogen::algorithm {
namespace {

// Which expression of the moment n = axial(U S): three ways to write the same vector.
enum class MomentForm {
  products,   // all components from products of U and S
  z_by_rate,  // z component as wd_z I_zz + w_x w_y (S_xx - S_yy) + …
  euler,      // I wd + w x I w
};

// w x momentum * rate. Of a constant momentum along three axes in multiples of its largest component: a product less.
Vector3 gyroscopic_moment(const Vector3& w, const Spin& spin) {
  const Vector3& momentum = spin.momentum;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (momentum[i].is_zero() || !momentum[i].is_constant()) return cross(w, spin.rate * momentum);
    const auto size = [&](std::size_t k) { return std::abs(momentum[k].number().value()); };
    if (size(i) > size(largest)) largest = i;
  }
  const Expression& unit = momentum[largest];
  Vector3 direction;
  for (std::size_t i = 0; i < 3; ++i) direction[i] = i == largest ? unit.graph()->one() : momentum[i] / unit;
  const Expression rate = unit * spin.rate;
  return cross(rate * w, direction);
}

Vector3 moment_about_origin(const MassProperties& m, const AngularState& state, MomentForm form) {
  const Matrix3& s = m.pseudo_inertia;
  const Vector3 &w = state.w, &wd = state.wd;
  const auto u = [&](std::size_t row, std::size_t column) { return state.u(row, column); };
  if (form == MomentForm::euler) {
    const Matrix3 inertia = inertia_tensor(m);
    const Vector3 euler = multiply(inertia, wd);
    return euler + cross(w, multiply(inertia, w));
  }
  const Expression xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
  if (!state.link.empty()) {
    describe(xx, state.link + "_wx2");
    describe(yy, state.link + "_wy2");
    describe(zz, state.link + "_wz2");
  }
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

}  // namespace

// Off the diagonal w_r w_c plus or minus the remaining component of wd; on it minus the squares of the others.
Expression AngularState::u(std::size_t row, std::size_t column) const {
  constexpr const char* axes = "xyz";
  const bool is_named = !link.empty();
  const auto named = [&](const Expression& e) {
    if (is_named) describe(e, link + "_U" + axes[row] + axes[column]);
    return e;
  };
  if (row == column) {
    const std::size_t i = (row + 1) % 3, j = (row + 2) % 3;
    const Expression &a = w[std::min(i, j)], &b = w[std::max(i, j)];
    return named(-sum_of_products(a, a, b, b));
  }
  const std::size_t other = 3 - row - column;
  const Expression product = w[row] * w[column];
  if (is_named) describe(product, link + "_w" + axes[std::min(row, column)] + "_w" + axes[std::max(row, column)]);
  return named(column == (row + 1) % 3 ? product - wd[other] : product + wd[other]);
}

Vector3 multiply_u(const AngularState& state, const Vector3& v) {
  Vector3 result;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      if (!v[c].is_zero()) result[r] += state.u(r, c) * v[c];
  return result;
}

LinkMotion base_motion(const Motion& velocity, const Motion& acceleration, const Vector3& gravity) {
  const Vector3 free = acceleration.linear - gravity;
  return {{velocity.angular, acceleration.angular}, free + cross(velocity.angular, velocity.linear)};
}

Force link_wrench(
    Trace& trace,
    const MassProperties& m,
    const LinkMotion& motion,
    const std::vector<Spin>& spins,
    bool only_z_moment) {
  Force wrench;
  if (!only_z_moment) {
    wrench.linear = multiply_u(motion.angular, m.first_moment);
    if (!m.mass.is_zero()) wrench.linear += m.mass * motion.a;
  }
  const auto moment = [&](MomentForm form) {
    Vector3 n = moment_about_origin(m, motion.angular, form);
    n += cross(m.first_moment, motion.a);
    for (const Spin& spin : spins) {
      n += spin.acceleration * spin.momentum;
      n += gyroscopic_moment(motion.angular.w, spin);
    }
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
  wrench.moment = moment(best);
  return wrench;
}

}  // namespace robcogen::algorithm
