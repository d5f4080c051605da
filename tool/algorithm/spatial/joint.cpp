#include "algorithm/spatial/joint.h"

#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using model::JointType;

constexpr std::size_t z = 2;

// e x v, for a unit vector e along an axis.
Vector3 cross_axis(std::size_t axis, const Vector3& v) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  Vector3 result;
  result[i] = -v[j];
  result[j] = v[i];
  return result;
}

Vector3 cross_z(const Vector3& v) {
  return cross_axis(z, v);
}

// The values of the components of a spherical joint, given the first one.
Vector3 of_components(const Joint& first, const std::vector<Expression>& by_joint) {
  const std::size_t j = at(first.index);
  return {by_joint[j], by_joint[j + 1], by_joint[j + 2]};
}

// Whether another component of a spherical joint moves the child for this one.
bool is_later_component(const Joint& joint) {
  return joint.is_spherical() && joint.axis > 0;
}

// (v x z) * length in x and y, and `along` in z.
Vector3 cross_with_z(const Vector3& v, const Expression& length, const Expression& along) {
  return {v[1] * length, -(v[0] * length), along};
}

// The force that a body takes per unit of acceleration about an axis, or along z.
Force of_turning(const MassProperties& body, std::size_t axis = z) {
  const Matrix3& s = body.pseudo_inertia;
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  Force force;
  force.moment[i] = -s[i][axis];
  force.moment[j] = -s[j][axis];
  force.moment[axis] = s[i][i] + s[j][j];
  force.linear = cross_axis(axis, body.first_moment);
  return force;
}

Force of_sliding(const MassProperties& body) {
  const Vector3& h = body.first_moment;
  const Expression zero;
  return {{h[1], -h[0], zero}, {zero, zero, body.mass}};
}

Force of_turning(const SpatialInertia& body, std::size_t axis = z) {
  const auto& [a, b, m] = body;
  return {{a[0][axis], a[1][axis], a[2][axis]}, b[axis]};
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
    case JointType::spherical:
      return of_turning(body, at(joint.axis));
  }
  return of_turning(body);
}

}  // namespace

Joint joint_of(Trace& trace, int index) {
  const model::Joint& joint = trace.tree.joints[at(index)];
  const bool is_helical = joint.type == JointType::helical;
  return {index, joint.child, joint.type, is_helical ? trace.lift(joint.pitch) : Expression(), joint.axis};
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
    case JointType::spherical:
      w[at(joint.axis)] += rate;
      return;
  }
}

void add_rates(const Joint& joint, const std::vector<Expression>& qd, Vector3& w, Vector3& v) {
  if (!joint.is_spherical())
    add_rate(joint, qd[at(joint.index)], w, v);
  else if (!is_later_component(joint))
    w += of_components(joint, qd);
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
    case JointType::spherical:
      return F_C.moment[at(joint.axis)];
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
    case JointType::spherical:
      F_C.moment[at(joint.axis)] = value;
      return;
  }
}

Expression take_rate(const Joint& joint, Motion& V_C) {
  Expression& along = (model::turns(joint.type) ? V_C.angular : V_C.linear)[at(joint.axis)];
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
    case JointType::spherical:
      return {cross_axis(at(joint.axis), V_C.angular), cross_axis(at(joint.axis), V_C.linear)};
  }
  return {cross_z(V_C.angular), cross_z(V_C.linear)};
}

bool feels_only_moment(const Joint& joint) {
  return joint.type == JointType::revolute;
}

Motion across_joint(const Joint& joint, const Pose& X_PC, const Motion& V_P, const std::vector<Expression>& qd) {
  if (is_later_component(joint)) return V_P;
  Motion V_C = to_child(X_PC, V_P);
  add_rates(joint, qd, V_C.angular, V_C.linear);
  return V_C;
}

LinkMotion carried_motion(const Pose& X_PC, const LinkMotion& parent) {
  const Vector3 w = to_child(X_PC.rotation, parent.angular.w);
  const Vector3 wd = to_child(X_PC.rotation, parent.angular.wd);
  const Vector3 carried = parent.a + multiply_u(parent.angular, X_PC.offset);
  if (const Graph* graph = carried[0].graph()) described("a", in_parent(graph->subject()), carried);
  return {{w, wd}, to_child(X_PC.rotation, carried)};
}

LinkMotion across_joint(
    const Joint& joint,
    const Pose& X_PC,
    const LinkMotion& parent,
    const std::vector<Expression>& qd_of_joints,
    const std::vector<Expression>& qdd_of_joints) {
  if (is_later_component(joint)) return parent;
  LinkMotion child = carried_motion(X_PC, parent);
  Vector3 &w = child.angular.w, &wd = child.angular.wd;
  const Expression &qd = qd_of_joints[at(joint.index)], &qdd = qdd_of_joints[at(joint.index)];
  switch (joint.type) {
    case JointType::prismatic:
      child.a += cross_with_z(w, qd + qd, qdd);
      break;
    case JointType::helical: {
      const Expression slide = joint.pitch * qd;
      child.a += cross_with_z(w, slide + slide, joint.pitch * qdd);
      [[fallthrough]];
    }
    case JointType::revolute:
      wd += cross_with_z(w, qd, qdd);
      w[z] += qd;
      break;
    case JointType::spherical: {
      const Vector3 rate = of_components(joint, qd_of_joints);
      wd += cross(w, rate) + of_components(joint, qdd_of_joints);
      w += rate;
      break;
    }
  }
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

// With the blocks A, B, M of the result and S = (z; p z), or S about another axis for a spherical joint: A z = -p B z
// and B' z = -p M z, both zero without a pitch. For a prismatic joint B z and M z are zero.
SpatialInertia released(const SpatialInertia& body, const Joint& joint, const Force& U, const Force& gain) {
  const bool turns = model::turns(joint.type);
  const std::size_t k = at(joint.axis);
  SpatialInertia x = body;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = r; c < 3; ++c) {
      const bool along = r == k || c == k;
      x.a[r][c] = x.a[c][r] = turns && along ? Expression() : x.a[r][c] - U.moment[r] * gain.moment[c];
      x.m[r][c] = x.m[c][r] = !turns && along ? Expression() : x.m[r][c] - U.linear[r] * gain.linear[c];
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      const bool axis = turns ? r == k : c == k;
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
