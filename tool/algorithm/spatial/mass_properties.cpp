#include "algorithm/spatial/mass_properties.h"

namespace robcogen::algorithm {
namespace {

// The mass properties about a point displaced by -p: S + h2 p' + p h2' with h2 = h + m p / 2, and h + m p.
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

}  // namespace robcogen::algorithm
