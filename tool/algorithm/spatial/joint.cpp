#include "algorithm/spatial/joint.h"

#include "algorithm/spatial/describe.h"

namespace robcogen::algorithm {
namespace {

constexpr std::size_t z = 2;

bool is_revolute(const Joint& joint) {
  return joint.type == model::JointType::revolute;
}

// z x v.
Vector3 cross_z(const Vector3& v) {
  return {-v[1], v[0], Expression()};
}

}  // namespace

Joint joint_of(const model::KinematicTree& tree, int index) {
  const model::Joint& joint = tree.joints[at(index)];
  return {index, joint.child, joint.type};
}

Motion subspace(const Joint& joint, Graph& graph) {
  Motion S;
  add_rate(joint, graph.one(), S);
  return S;
}

void add_rate(const Joint& joint, const Expression& rate, Vector3& w, Vector3& v) {
  (is_revolute(joint) ? w : v)[z] += rate;
}

void add_rate(const Joint& joint, const Expression& rate, Motion& V_C) {
  add_rate(joint, rate, V_C.angular, V_C.linear);
}

Expression project(const Joint& joint, const Force& F_C) {
  return is_revolute(joint) ? F_C.moment[z] : F_C.linear[z];
}

void set_projection(const Joint& joint, const Expression& value, Force& F_C) {
  (is_revolute(joint) ? F_C.moment : F_C.linear)[z] = value;
}

Expression take_rate(const Joint& joint, Motion& V_C) {
  Expression& along = (is_revolute(joint) ? V_C.angular : V_C.linear)[z];
  const Expression rate = along;
  along = Expression();
  return rate;
}

Motion cross_subspace(const Joint& joint, const Motion& V_C) {
  if (is_revolute(joint)) return {cross_z(V_C.angular), cross_z(V_C.linear)};
  return {Vector3(), cross_z(V_C.angular)};
}

bool feels_only_moment(const Joint& joint) {
  return is_revolute(joint);
}

Motion across_joint(const Joint& joint, const Pose& X_PC, const Motion& V_P, const Expression& qd) {
  Motion V_C = to_child(X_PC, V_P);
  add_rate(joint, qd, V_C);
  return V_C;
}

LinkMotion across_joint(
    const Joint& joint,
    const Pose& X_PC,
    const LinkMotion& parent,
    const Expression& qd,
    const Expression& qdd) {
  Vector3 w = to_child(X_PC.rotation, parent.angular.w);
  Vector3 wd = to_child(X_PC.rotation, parent.angular.wd);
  const Vector3 carried = parent.a + multiply_u(parent.angular, X_PC.offset);
  if (const Graph* graph = carried[0].graph()) describe(carried, graph->subject() + "_a", "_P");
  Vector3 a = to_child(X_PC.rotation, carried);
  if (is_revolute(joint)) {
    wd += Vector3{w[1] * qd, -(w[0] * qd), qdd};
    w[z] += qd;
  } else {
    const Expression twice = qd + qd;
    a += Vector3{w[1] * twice, -(w[0] * twice), qdd};
  }
  LinkMotion child{{w, wd}, a};
  if (!X_PC.slide.is_zero())
    for (std::size_t i = 0; i < 3; ++i) child.a[i] += X_PC.slide * child.angular.u(i, z);
  return child;
}

Force times_subspace(const MassProperties& body, const Joint& joint) {
  const Vector3& h = body.first_moment;
  const Matrix3& s = body.pseudo_inertia;
  const Expression zero;
  if (is_revolute(joint)) return {{-s[0][2], -s[1][2], s[0][0] + s[1][1]}, {-h[1], h[0], zero}};
  return {{h[1], -h[0], zero}, {zero, zero, body.mass}};
}

Force times_subspace(const SpatialInertia& body, const Joint& joint) {
  const auto& [a, b, m] = body;
  if (is_revolute(joint)) return {{a[0][z], a[1][z], a[z][z]}, b[z]};
  return {{b[0][z], b[1][z], b[z][z]}, {m[0][z], m[1][z], m[z][z]}};
}

SpatialInertia reduced(const SpatialInertia& body, const Force& U, const Force& gain) {
  SpatialInertia x = body;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = r; c < 3; ++c) {
      x.a[r][c] = x.a[c][r] = x.a[r][c] - U.moment[r] * gain.moment[c];
      x.m[r][c] = x.m[c][r] = x.m[r][c] - U.linear[r] * gain.linear[c];
    }
    for (std::size_t c = 0; c < 3; ++c) x.b[r][c] -= gain.moment[r] * U.linear[c];
  }
  return x;
}

SpatialInertia released(const SpatialInertia& body, const Joint& joint, const Force& U, const Force& gain) {
  const bool revolute = is_revolute(joint);
  SpatialInertia x = body;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = r; c < 3; ++c) {
      x.a[r][c] = x.a[c][r] = revolute && c == z ? Expression() : x.a[r][c] - U.moment[r] * gain.moment[c];
      x.m[r][c] = x.m[c][r] = !revolute && c == z ? Expression() : x.m[r][c] - U.linear[r] * gain.linear[c];
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const bool axis = revolute ? r == z : c == z;
      const Expression share = revolute ? gain.moment[r] * U.linear[c] : U.moment[r] * gain.linear[c];
      x.b[r][c] = axis ? Expression() : x.b[r][c] - share;
    }
  }
  return x;
}

}  // namespace robcogen::algorithm
