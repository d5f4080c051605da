#include "algorithm/spatial/link_motion.h"

#include "algorithm/spatial/named.h"
#include "symbolic/cost.h"

#include <algorithm>
#include <cmath>

namespace robcogen::algorithm {
namespace {

// Two equivalent expressions for the z component of the moment n = axial(U S).
enum class MomentForm {
  products,  // of U and S
  by_rate,   // wd_z I_zz + w_x w_y (S_xx - S_yy) + …
};

// w x momentum * rate. A constant momentum with three components is taken in multiples of its largest one, which saves
// a product.
Vector3 gyroscopic_moment(const Vector3& w, const RotorMotion& rotor) {
  const Vector3& momentum = rotor.momentum;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (momentum[i].is_zero() || !momentum[i].is_constant()) return cross(w, rotor.rate * momentum);
    const auto size = [&](std::size_t k) { return std::abs(momentum[k].number().value()); };
    if (size(i) > size(largest)) largest = i;
  }
  const Expression& unit = momentum[largest];
  Vector3 direction;
  for (std::size_t i = 0; i < 3; ++i) direction[i] = i == largest ? unit.graph()->one() : momentum[i] / unit;
  const Expression rate = unit * rotor.rate;
  return cross(rate * w, direction);
}

// The moment as I wd + w x I w.
Vector3 euler_moment(const MassProperties& m, const AngularState& state) {
  const Matrix3 inertia = inertia_tensor(m);
  const Vector3 euler = multiply(inertia, state.wd);
  return euler + cross(state.w, multiply(inertia, state.w));
}

// The x and y components of the moment from products of U and S; z is zero.
Vector3 moment_across(const MassProperties& m, const AngularState& state) {
  const Matrix3& s = m.pseudo_inertia;
  const Vector3& w = state.w;
  const auto u = [&](std::size_t row, std::size_t column) { return state.u(row, column); };
  const Expression xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
  if (!state.link.empty()) {
    described_product_of_w(state.link, 0, 0, xx);
    described_product_of_w(state.link, 1, 1, yy);
    described_product_of_w(state.link, 2, 2, zz);
  }
  // Terms are added one after the other, so that every compiler creates them in the same order.
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
  return {nx, ny, Expression()};
}

Expression moment_about_z(const MassProperties& m, const AngularState& state, MomentForm form) {
  const Matrix3& s = m.pseudo_inertia;
  const Vector3 &w = state.w, &wd = state.wd;
  const auto u = [&](std::size_t row, std::size_t column) { return state.u(row, column); };
  Expression nz;
  if (form == MomentForm::products) {
    nz = u(1, 0) * s[0][0];
    nz -= u(0, 1) * s[1][1];
  } else {
    nz = wd[2] * (s[0][0] + s[1][1]);
    const Expression product = w[0] * w[1];
    nz += product * (s[0][0] - s[1][1]);
  }
  const Expression xx = w[0] * w[0], yy = w[1] * w[1];
  nz += (yy - xx) * s[0][1];
  nz += u(1, 2) * s[0][2];
  nz -= u(0, 2) * s[1][2];
  return nz;
}

// The form of the moment that adds the fewest operations; `completed` adds the terms that all forms share.
template <class Complete>
Vector3 cheapest_moment(Graph& graph, const MassProperties& m, const AngularState& state, const Complete& completed) {
  const std::size_t start = graph.mark();
  completed(euler_moment(m, state));
  const int of_euler = symbolic::work_since(graph, start);
  graph.rollback(start);
  const auto moment = [&](const Vector3& across, MomentForm form) {
    return completed({across[0], across[1], moment_about_z(m, state, form)});
  };
  const Vector3 across = moment_across(m, state);
  const std::size_t middle = graph.mark();
  moment(across, MomentForm::products);
  const int of_products = symbolic::work_since(graph, start);
  graph.rollback(middle);
  const Vector3 by_rate = moment(across, MomentForm::by_rate);
  if (symbolic::work_since(graph, start) <= std::min(of_products, of_euler)) return by_rate;
  graph.rollback(start);
  if (of_euler < of_products) return completed(euler_moment(m, state));
  return moment(moment_across(m, state), MomentForm::products);
}

}  // namespace

// Off the diagonal: w_r w_c plus or minus the remaining component of wd. On the diagonal: minus the squares of the
// other components of w.
Expression AngularState::u(std::size_t row, std::size_t column) const {
  const auto named = [&](const Expression& e) { return link.empty() ? e : described_u(link, row, column, e); };
  if (row == column) {
    const std::size_t i = (row + 1) % 3, j = (row + 2) % 3;
    const Expression &a = w[std::min(i, j)], &b = w[std::max(i, j)];
    return named(-sum_of_products(a, a, b, b));
  }
  const std::size_t other = 3 - row - column;
  const Expression product = w[row] * w[column];
  if (!link.empty()) described_product_of_w(link, row, column, product);
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
    const std::vector<RotorMotion>& rotors,
    bool only_z_moment) {
  Force wrench;
  if (!only_z_moment) {
    wrench.linear = multiply_u(motion.angular, m.first_moment);
    if (!m.mass.is_zero()) wrench.linear += m.mass * motion.a;
  }
  wrench.moment = cheapest_moment(trace.graph, m, motion.angular, [&](Vector3 n) {
    n += cross(m.first_moment, motion.a);
    for (const RotorMotion& rotor : rotors) {
      n += rotor.acceleration * rotor.momentum;
      n += gyroscopic_moment(motion.angular.w, rotor);
    }
    return only_z_moment ? Vector3{Expression(), Expression(), n[2]} : n;
  });
  return wrench;
}

}  // namespace robcogen::algorithm
