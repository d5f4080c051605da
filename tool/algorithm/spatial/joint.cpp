#include "algorithm/spatial/joint.h"

#include "algorithm/spatial/describe.h"

namespace robcogen::algorithm {
namespace {

using model::JointType;

constexpr std::size_t z = 2;

// z x v.
Vector3 cross_z(const Vector3& v) {
  return {-v[1], v[0], Expression()};
}

// v x z.
Vector3 cross_with_z(const Vector3& v, const Expression& length, const Expression& along) {
  return {v[1] * length, -(v[0] * length), along};
}

// What a body takes per unit of turning about z, and of sliding along it.
Force of_turning(const MassProperties& body) {
  const Vector3& h = body.first_moment;
  const Matrix3& s = body.pseudo_inertia;
  return {{-s[0][2], -s[1][2], s[0][0] + s[1][1]}, {-h[1], h[0], Expression()}};
}

Force of_sliding(const MassProperties& body) {
  const Vector3& h = body.first_moment;
  const Expression zero;
  return {{h[1], -h[0], zero}, {zero, zero, body.mass}};
}

Force of_turning(const SpatialInertia& body) {
  const auto& [a, b, m] = body;
  return {{a[0][z], a[1][z], a[z][z]}, b[z]};
}

Force of_sliding(const SpatialInertia& body) {
  const auto& [a, b, m] = body;
  return {{b[0][z], b[1][z], b[z][z]}, {m[0][z], m[1][z], m[z][z]}};
}

template <class Body>
Force inertia_times_subspace(const Body& body, const Joint& joint) {
  switch (joint.type) {
    case JointType::revolute:
      break;
    case JointType::prismatic:
      return of_sliding(body);
    case JointType::helical: {
      Force force = of_turning(body);
      force += joint.pitch * of_sliding(body);
      return force;
    }
  }
  return of_turning(body);
}

}  // namespace

Joint joint_of(Trace& trace, int index) {
  const model::Joint& joint = trace.tree.joints[at(index)];
  const bool is_helical = joint.type == JointType::helical;
  return {index, joint.child, joint.type, is_helical ? trace.lift(joint.pitch) : Expression()};
}

Motion subspace(const Joint& joint, Graph& graph) {
  Motion S;
  add_rate(joint, graph.one(), S);
  return S;
}

void add_rate(const Joint& joint, const Expression& rate, Vector3& w, Vector3& v) {
  switch (joint.type) {
    case JointType::revolute:
      w[z] += rate;
      return;
    case JointType::prismatic:
      v[z] += rate;
      return;
    case JointType::helical:
      w[z] += rate;
      v[z] += joint.pitch * rate;
      return;
  }
}

void add_rate(const Joint& joint, const Expression& rate, Motion& V_C) {
  add_rate(joint, rate, V_C.angular, V_C.linear);
}

Expression project(const Joint& joint, const Force& F_C) {
  switch (joint.type) {
    case JointType::revolute:
      break;
    case JointType::prismatic:
      return F_C.linear[z];
    case JointType::helical:
      return F_C.moment[z] + joint.pitch * F_C.linear[z];
  }
  return F_C.moment[z];
}

void set_projection(const Joint& joint, const Expression& value, Force& F_C) {
  switch (joint.type) {
    case JointType::revolute:
      F_C.moment[z] = value;
      return;
    case JointType::prismatic:
      F_C.linear[z] = value;
      return;
    case JointType::helical:
      F_C.moment[z] = value - joint.pitch * F_C.linear[z];
      return;
  }
}

Expression take_rate(const Joint& joint, Motion& V_C) {
  Expression& along = (model::turns(joint.type) ? V_C.angular : V_C.linear)[z];
  const Expression rate = along;
  along = Expression();
  if (joint.type == JointType::helical) V_C.linear[z] -= joint.pitch * rate;
  return rate;
}

Motion cross_subspace(const Joint& joint, const Motion& V_C) {
  switch (joint.type) {
    case JointType::revolute:
      break;
    case JointType::prismatic:
      return {Vector3(), cross_z(V_C.angular)};
    case JointType::helical:
      return {cross_z(V_C.angular), cross_z(V_C.linear) + joint.pitch * cross_z(V_C.angular)};
  }
  return {cross_z(V_C.angular), cross_z(V_C.linear)};
}

bool feels_only_moment(const Joint& joint) {
  return joint.type == JointType::revolute;
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
  switch (joint.type) {
    case JointType::prismatic:
      a += cross_with_z(w, qd + qd, qdd);
      break;
    case JointType::helical: {
      const Expression slide = joint.pitch * qd;
      a += cross_with_z(w, slide + slide, joint.pitch * qdd);
      [[fallthrough]];
    }
    case JointType::revolute:
      wd += cross_with_z(w, qd, qdd);
      w[z] += qd;
      break;
  }
  LinkMotion child{{w, wd}, a};
  if (!X_PC.slide.is_zero())
    for (std::size_t i = 0; i < 3; ++i) child.a[i] += X_PC.slide * child.angular.u(i, z);
  return child;
}

Force times_subspace(const MassProperties& body, const Joint& joint) {
  return inertia_times_subspace(body, joint);
}

Force times_subspace(const SpatialInertia& body, const Joint& joint) {
  return inertia_times_subspace(body, joint);
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

// With the blocks A, B, M and S = (z; p z): A z = -p B z and B' z = -p M z, both zero without a pitch. Of a prismatic
// joint B z and M z are zero.
SpatialInertia released(const SpatialInertia& body, const Joint& joint, const Force& U, const Force& gain) {
  const bool turns = model::turns(joint.type);
  SpatialInertia x = body;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = r; c < 3; ++c) {
      x.a[r][c] = x.a[c][r] = turns && c == z ? Expression() : x.a[r][c] - U.moment[r] * gain.moment[c];
      x.m[r][c] = x.m[c][r] = !turns && c == z ? Expression() : x.m[r][c] - U.linear[r] * gain.linear[c];
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const bool axis = turns ? r == z : c == z;
      const Expression share = turns ? gain.moment[r] * U.linear[c] : U.moment[r] * gain.linear[c];
      x.b[r][c] = axis ? Expression() : x.b[r][c] - share;
    }
  }
  if (joint.type != JointType::helical) return x;
  for (std::size_t c = 0; c < 3; ++c) x.b[z][c] = -(joint.pitch * x.m[z][c]);
  for (std::size_t r = 0; r < 3; ++r) x.a[r][z] = x.a[z][r] = -(joint.pitch * x.b[r][z]);
  return x;
}

}  // namespace robcogen::algorithm
