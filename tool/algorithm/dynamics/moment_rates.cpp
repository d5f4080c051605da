#include "algorithm/dynamics/moment_rates.h"

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

void add_product(Matrix3& m, const Vector3& a, const Vector3& b) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) m[r][c] += a[r] * b[c];
}

// [w]x S, for a symmetric S.
Matrix3 moment_rates_of_rigid_body(const Vector3& w, const Matrix3& s) {
  const std::array<Vector3, 3> columns = {cross(w, s[0]), cross(w, s[1]), cross(w, s[2])};
  Matrix3 k;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) k[r][c] = columns[c][r];
  return k;
}

// Moves the reference to an origin from which the old one is at p, with rate p'. `first_moment` is about the new
// origin.
void displace(
    MomentRates& body,
    const Expression& mass,
    const Vector3& first_moment,
    const Vector3& p,
    const Vector3& rate) {
  add_product(body.K, body.l, p);
  add_product(body.K, rate, first_moment);
  body.l += mass * rate;
}

// `child` are the mass properties of the same body.
MomentRates to_parent(const Pose& pose, const OriginRate& rate, const MassProperties& child, const MomentRates& body) {
  const Vector3 slide{Expression(), Expression(), pose.slide};
  MomentRates result = body;
  Vector3 h = child.first_moment + child.mass * slide;
  displace(result, child.mass, h, slide, rate.slide);
  result = {to_parent(pose.rotation, result.l), general_to_parent(pose.rotation, result.K)};
  h = to_parent(pose.rotation, h) + child.mass * pose.offset;
  displace(result, child.mass, h, pose.offset, rate.offset);
  return result;
}

}  // namespace

Vector3 rate_of_z(const Vector3& w) {
  return {w[1], -w[0], Expression()};
}

CompositeMotion::CompositeMotion(const TracedRobot& robot, const std::vector<Expression>& qd, const Vector3& base_w)
    : composite(composite_bodies(robot)),
      moment_rates(robot.tree().links.size()),
      w(robot.tree().links.size()),
      rates(robot.tree().joints.size()),
      robot_(robot),
      qd_(qd) {
  collect(0, base_w);
}

void CompositeMotion::collect(int link, const Vector3& velocity) {
  w[at(link)] = velocity;
  const MassProperties& own = robot_.mass(link);
  moment_rates[at(link)] = {
      cross(velocity, own.first_moment), moment_rates_of_rigid_body(velocity, own.pseudo_inertia)};
  described("l", {robot_.link_name(link), "own"}, moment_rates[at(link)].l);
  described("K", {robot_.link_name(link), "own"}, moment_rates[at(link)].K);
  for (const Joint& joint : robot_.children(link)) {
    const std::string& name = robot_.link_name(joint.child);
    robot_.trace.section(name, "link ", ": velocity and rates of mass moments");
    const Pose& X_PC = robot_.pose(joint.index);
    Vector3 turning = to_child(X_PC.rotation, velocity), sliding;
    add_rates(joint, qd_, turning, sliding);
    named("w", name, turning);
    OriginRate& rate = rates[at(joint.index)];
    rate = {cross(velocity, X_PC.offset), X_PC.slide * rate_of_z(turning) + sliding};
    collect(joint.child, turning);
    if (!robot_.parent_matters(joint.child)) continue;
    described("rd", name, rate.offset);
    described("sd", name, rate.slide);
    const MomentRates in_P = to_parent(X_PC, rate, composite[at(joint.child)], moment_rates[at(joint.child)]);
    described("l", in_parent(name), in_P.l);
    described("K", in_parent(name), in_P.K);
    moment_rates[at(link)].l += in_P.l;
    moment_rates[at(link)].K = moment_rates[at(link)].K + in_P.K;
  }
  described("l", robot_.link_name(link), moment_rates[at(link)].l);
  described("K", robot_.link_name(link), moment_rates[at(link)].K);
}

Vector3 times_tensor_of(const Matrix3& K, const Vector3& v) {
  Vector3 result;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (v[c].is_zero()) continue;
      result[r] += (r == c ? K[(r + 1) % 3][(r + 1) % 3] + K[(r + 2) % 3][(r + 2) % 3] : -K[r][c]) * v[c];
    }
  }
  return result;
}

ChangeOfMotion to_parent(const Pose& X_PC, const OriginRate& rate, const ChangeOfMotion& x) {
  const Vector3 slid = x.e + cross(rate.slide, x.Q.linear);
  const Force Q = to_parent(X_PC, x.Q);
  return {Q, to_parent(X_PC.rotation, slid) + cross(rate.offset, Q.linear)};
}

Expression dot(const ChangeOfMotion& x, const FieldChange& field) {
  const Expression by_rate = dot(x.Q, field.rate);
  return by_rate + dot(x.e, field.turning);
}

Force wrench_of(const MassProperties& m, const MomentRates& body, const FieldChange& field) {
  const Motion& change = field.rate;
  Vector3 moment = multiply(inertia_tensor(m), change.angular);
  moment += cross(m.first_moment, change.linear);
  Vector3 force = cross(change.angular, m.first_moment);
  force += m.mass * change.linear;
  return {moment + times_tensor_of(body.K, field.turning), force + cross(field.turning, body.l)};
}

FieldChange change_of_field(const Vector3& w, const Motion& S) {
  return {S.angular, {cross(w, S.angular), cross(w, S.linear)}};
}

Force column_wrench(const MassProperties& m, const MomentRates& body, const Vector3& w, const Motion& S) {
  return wrench_of(m, body, change_of_field(w, S));
}

ChangeOfMotion row_of_joint(const MassProperties& m, const MomentRates& body, const Joint& joint, const Motion& S) {
  return {times_subspace(m, joint), times_tensor_of(transposed(body.K), S.angular) + cross(body.l, S.linear)};
}

Force on_fields_of_link(const ChangeOfMotion& x, const Vector3& w) {
  return {cross(x.Q.moment, w) + x.e, cross(x.Q.linear, w)};
}

}  // namespace robcogen::algorithm
