// The Coriolis matrix, from composite bodies and how they spread.
//
// A particle at p, seen from the origin of a link that supports it, moves by u = a_v + a_w x p per unit rate of a
// coordinate. With C_ij = integral of u_i (du_j/dt) dm, dH/dt - 2 C is skew symmetric, because H_ij = integral of u_i
// u_j dm. The derivative of u, in resting axes, is a_v' + a_w' x p + a_w x p': so, beside mass, first moment h and
// pseudo-inertia, a composite body needs l = integral of p' dm and K = integral of p' p^T dm. Then the wrench about the
// origin that belongs to du/dt is
//     f = m a_v' + a_w' x h + a_w x l,     n = h x a_v' + I a_w' + (tr(K) 1 - K) a_w.
//
// A rotor adds the momentum p per unit rate of its joint, fixed in its carrier, to the wrenches about the carrier: w x
// p to that of the column, and p to what multiplies a_w' in the row.
#include <functional>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/spatial/describe.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// l and K of a composite body, about its link's origin in link axes.
struct Spread {
  Vector3 l;
  Matrix3 K;
};

// How the vector from the parent's origin to the child's changes, in the two parts of Pose.
struct OriginRate {
  Vector3 offset;  // parent axes
  Vector3 slide;   // child axes
};

// w x z, the rate of a link's z axis.
Vector3 rate_of_z(const Vector3& w) {
  return {w[1], -w[0], Expression()};
}

void add_product(Matrix3& m, const Vector3& a, const Vector3& b) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) m[r][c] += a[r] * b[c];
}

// [w]x S, for a symmetric S.
Matrix3 spread_of_rigid_body(const Vector3& w, const Matrix3& s) {
  const std::array<Vector3, 3> columns = {cross(w, s[0]), cross(w, s[1]), cross(w, s[2])};
  Matrix3 k;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) k[r][c] = columns[c][r];
  return k;
}

// About an origin from which the old one is at p, with rate p'. `first_moment` is about the new origin.
void displace(
    Spread& body,
    const Expression& mass,
    const Vector3& first_moment,
    const Vector3& p,
    const Vector3& rate) {
  add_product(body.K, body.l, p);
  add_product(body.K, rate, first_moment);
  body.l += mass * rate;
}

// `child` are the mass properties of the same body.
Spread to_parent(const Pose& pose, const OriginRate& rate, const MassProperties& child, const Spread& body) {
  const Vector3 slide{Expression(), Expression(), pose.slide};
  Spread result = body;
  Vector3 h = child.first_moment + child.mass * slide;
  displace(result, child.mass, h, slide, rate.slide);
  result = {to_parent(pose.rotation, result.l), general_to_parent(pose.rotation, result.K)};
  h = to_parent(pose.rotation, h) + child.mass * pose.offset;
  displace(result, child.mass, h, pose.offset, rate.offset);
  return result;
}

// The integral of one motion field times the change of another, as a linear form of the latter: Q = (n, f) multiplies
// (a_w', a_v'), e multiplies a_w.
struct ChangeOfMotion {
  Force Q;
  Vector3 e;
};

ChangeOfMotion to_parent(const Pose& X_PC, const OriginRate& rate, const ChangeOfMotion& x) {
  const Vector3 slid = x.e + cross(rate.slide, x.Q.linear);
  const Force Q = to_parent(X_PC, x.Q);
  return {Q, to_parent(X_PC.rotation, slid) + cross(rate.offset, Q.linear)};
}

// The integrals of the composite bodies, and how their links move.
class SpreadBodies {
 public:
  SpreadBodies(const TracedRobot& robot, const std::vector<Expression>& qd, const Vector3& base_w)
      : composite(composite_bodies(robot)),
        spread(robot.tree().links.size()),
        w(robot.tree().links.size()),
        rates(robot.tree().joints.size()),
        robot_(robot),
        qd_(qd) {
    collect(0, base_w);
  }

  std::vector<MassProperties> composite;  // by link, as the next two
  std::vector<Spread> spread;
  std::vector<Vector3> w;         // angular velocity, link axes
  std::vector<OriginRate> rates;  // by joint

 private:
  const TracedRobot& robot_;
  const std::vector<Expression>& qd_;

  void collect(int link, const Vector3& velocity) {
    w[at(link)] = velocity;
    const MassProperties& own = robot_.mass(link);
    spread[at(link)] = {cross(velocity, own.first_moment), spread_of_rigid_body(velocity, own.pseudo_inertia)};
    describe(spread[at(link)].l, robot_.link_name(link) + "_own_l");
    describe(spread[at(link)].K, robot_.link_name(link) + "_own_K");
    for (const Joint& joint : robot_.children(link)) {
      const std::string& name = robot_.link_name(joint.child);
      robot_.trace.section(name, "link " + name + ": velocity and spread");
      const Pose& X_PC = robot_.pose(joint.index);
      Vector3 turning = to_child(X_PC.rotation, velocity), sliding;
      add_rate(joint, qd_[at(joint.index)], turning, sliding);
      algorithm::name(robot_.trace.graph, turning, name + "_w");
      OriginRate& rate = rates[at(joint.index)];
      rate = {cross(velocity, X_PC.offset), X_PC.slide * rate_of_z(turning) + sliding};
      collect(joint.child, turning);
      if (!robot_.parent_matters(joint.child)) continue;
      describe(rate.offset, name + "_rd");
      describe(rate.slide, name + "_sd");
      const Spread seen = to_parent(X_PC, rate, composite[at(joint.child)], spread[at(joint.child)]);
      describe(seen.l, name + "_l", "_P");
      describe(seen.K, name + "_K", "_P");
      spread[at(link)].l += seen.l;
      spread[at(link)].K = spread[at(link)].K + seen.K;
    }
    describe(spread[at(link)].l, robot_.link_name(link) + "_l");
    describe(spread[at(link)].K, robot_.link_name(link) + "_K");
  }
};

Matrix3 transposed(const Matrix3& m) {
  return {{Vector3{m[0][0], m[1][0], m[2][0]}, Vector3{m[0][1], m[1][1], m[2][1]}, Vector3{m[0][2], m[1][2], m[2][2]}}};
}

// (tr(K) 1 - K) v.
Vector3 multiply_by_spread(const Matrix3& K, const Vector3& v) {
  Vector3 result;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (v[c].is_zero()) continue;
      result[r] += (r == c ? K[(r + 1) % 3][(r + 1) % 3] + K[(r + 2) % 3][(r + 2) % 3] : -K[r][c]) * v[c];
    }
  }
  return result;
}

// The wrench that belongs to the change of a joint's own motion field, whose axis turns with its link.
Force column_wrench(const MassProperties& m, const Spread& body, const Vector3& w, const Motion& S) {
  const Motion change{cross(w, S.angular), cross(w, S.linear)};
  Vector3 moment = multiply(inertia_tensor(m), change.angular);
  moment += cross(m.first_moment, change.linear);
  Vector3 force = cross(change.angular, m.first_moment);
  force += m.mass * change.linear;
  return {moment + multiply_by_spread(body.K, S.angular), force + cross(S.angular, body.l)};
}

ChangeOfMotion row_of_joint(const MassProperties& m, const Spread& body, const Joint& joint, const Motion& S) {
  return {times_subspace(m, joint), multiply_by_spread(transposed(body.K), S.angular) + cross(body.l, S.linear)};
}

// What the motion fields of a link that turns by w, about and along its axes, have of this.
Force on_fields_of_link(const ChangeOfMotion& x, const Vector3& w) {
  return {cross(x.Q.moment, w) + x.e, cross(x.Q.linear, w)};
}

// Row and column of a joint, as far up as the tree goes.
void fill_joint(const TracedRobot& robot, const SpreadBodies& bodies, int index, SquareMatrix& c) {
  const model::KinematicTree& tree = robot.tree();
  const int base = tree.floating_base ? 6 : 0;
  Joint joint = robot.joint(index);
  const std::size_t link = at(joint.child);
  const std::string& name = tree.links[link].name;
  robot.trace.section(name, "link " + name + ": row and column of joint " + tree.joints[at(index)].name);
  const Motion S = subspace(joint, robot.trace.graph);
  Force wrench = column_wrench(bodies.composite[link], bodies.spread[link], bodies.w[link], S);
  ChangeOfMotion row = row_of_joint(bodies.composite[link], bodies.spread[link], joint, S);
  c(base + index, base + index) = project(joint, wrench);
  const std::string& moving = tree.joints[at(index)].name;
  const auto describe_all = [&](const std::string& link_name) {
    describe(wrench, moving + "_" + link_name);
    describe(row.Q.moment, moving + "_" + link_name + "_Qn");
    describe(row.Q.linear, moving + "_" + link_name + "_Qf");
    describe(row.e, moving + "_" + link_name + "_e");
  };
  describe_all(name);
  while (robot.parent_matters(joint.child)) {
    const Pose& X_PC = robot.pose(joint.index);
    wrench = to_parent(X_PC, wrench);
    row = to_parent(X_PC, bodies.rates[at(joint.index)], row);
    const int reached = tree.joints[at(joint.index)].parent;
    const Vector3 momentum = rotor_momentum(robot, index, reached);
    wrench.moment += cross(bodies.w[at(reached)], momentum);
    row.Q.moment += momentum;
    const int parent = tree.parent_joint_of(joint.index);
    if (parent < 0) break;
    joint = robot.joint(parent);
    c(base + parent, base + index) = project(joint, wrench);
    c(base + index, base + parent) = project(joint, on_fields_of_link(row, bodies.w[at(joint.child)]));
    describe(c(base + parent, base + index), "C_" + tree.joints[at(parent)].name + "_" + moving);
    describe(c(base + index, base + parent), "C_" + moving + "_" + tree.joints[at(parent)].name);
    describe_all(robot.link_name(joint.child));
  }
  if (!tree.floating_base) return;
  const Force on_base = on_fields_of_link(row, bodies.w[0]);
  for (int k = 0; k < 3; ++k) {
    c(k, base + index) = wrench.moment[at(k)];
    c(3 + k, base + index) = wrench.linear[at(k)];
    c(base + index, k) = on_base.moment[at(k)];
    c(base + index, 3 + k) = on_base.linear[at(k)];
    for (const int r : {k, 3 + k}) {
      const std::string coordinate = coordinate_names(tree)[at(r)];
      describe(c(r, base + index), "C_" + coordinate + "_" + moving);
      describe(c(base + index, r), "C_" + moving + "_" + coordinate);
    }
  }
}

// The base's own motion fields: turning about its axes, sliding along them.
void fill_base(const TracedRobot& robot, const SpreadBodies& bodies, SquareMatrix& c) {
  robot.trace.section(robot.link_name(0), "base: rows and columns");
  const MassProperties& m = bodies.composite[0];
  const Matrix3& spread = bodies.spread[0].K;
  const Expression trace = spread[0][0] + spread[1][1] + spread[2][2];
  for (int k = 0; k < 3; ++k) {
    Vector3 axis;
    axis[at(k)] = robot.trace.graph.one();
    const Vector3 change = cross(bodies.w[0], axis);
    Vector3 moment = multiply(inertia_tensor(m), change);
    for (std::size_t r = 0; r < 3; ++r) moment[r] -= spread[r][at(k)];
    moment[at(k)] += trace;
    Vector3 force = cross(change, m.first_moment);
    force += cross(axis, bodies.spread[0].l);
    const Vector3 sliding_moment = cross(m.first_moment, change), sliding_force = m.mass * change;
    for (int r = 0; r < 3; ++r) {
      const auto row = at(r);
      c(r, k) = moment[row];
      c(3 + r, k) = force[row];
      c(r, 3 + k) = sliding_moment[row];
      c(3 + r, 3 + k) = sliding_force[row];
      const std::vector<std::string> names = coordinate_names(robot.tree());
      for (const int i : {r, 3 + r})
        for (const int j : {k, 3 + k}) describe(c(i, j), "C_" + names[at(i)] + "_" + names[at(j)]);
    }
  }
}

}  // namespace

Program coriolis_matrix(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const TracedRobot robot(trace, in.q, formulation);
  const SpreadBodies bodies(robot, in.qd, in.base_velocity.angular);
  const int size = tree.dof() + (tree.floating_base ? 6 : 0);
  SquareMatrix c(size);
  for (int j = 0; j < tree.dof(); ++j) fill_joint(robot, bodies, j, c);
  if (tree.floating_base) fill_base(robot, bodies, c);
  trace.output("C", Role::matrix, size, size, c.columns());
  return trace.program(name);
}

}  // namespace robcogen::algorithm
