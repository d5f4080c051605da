// The Coriolis matrix, from composite bodies and how they spread.
//
// A particle at p, seen from the origin of a link that supports it, moves by u = a_v + a_w x p per unit rate of a
// coordinate. With C_ij = integral of u_i (du_j/dt) dm, dH/dt - 2 C is skew symmetric, because H_ij = integral of u_i
// u_j dm. The derivative of u, in resting axes, is a_v' + a_w' x p + a_w x p': so, beside mass, first moment h and
// pseudo-inertia, a composite body needs l = integral of p' dm and K = integral of p' p^T dm. Then the wrench about the
// origin that belongs to du/dt is
//     f = m a_v' + a_w' x h + a_w x l,     n = h x a_v' + I a_w' + (tr(K) 1 - K) a_w.
#include <functional>

#include "algorithm/composite.h"
#include "algorithm/dynamics.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// l and K of a composite body, about its link's origin in link axes.
struct Spread {
  Vector3 drift;
  Matrix3 spread;
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
  add_product(body.spread, body.drift, p);
  add_product(body.spread, rate, first_moment);
  body.drift += mass * rate;
}

// `child` are the mass properties of the same body.
Spread to_parent(const Pose& pose, const OriginRate& rate, const MassProperties& child, const Spread& body) {
  const Vector3 slide{Expression(), Expression(), pose.slide};
  Spread result = body;
  Vector3 h = child.first_moment + child.mass * slide;
  displace(result, child.mass, h, slide, rate.slide);
  result = {to_parent(pose.rotation, result.drift), general_to_parent(pose.rotation, result.spread)};
  h = to_parent(pose.rotation, h) + child.mass * pose.offset;
  displace(result, child.mass, h, pose.offset, rate.offset);
  return result;
}

// The work that a motion field does on another's change: Q = (n, f) multiplies (a_w', a_v'), e multiplies a_w.
struct Covector {
  Spatial momentum;
  Vector3 drift;
};

Covector to_parent(const Pose& pose, const OriginRate& rate, const Covector& v) {
  const Vector3 slid = v.drift + cross(rate.slide, v.momentum.linear);
  const Spatial momentum = to_parent(pose, v.momentum);
  return {momentum, to_parent(pose.rotation, slid) + cross(rate.offset, momentum.linear)};
}

class Bodies {
 public:
  Bodies(const Setup& setup, const std::vector<Expression>& qd, const Vector3& base_w)
      : composite(composite_bodies(setup)),
        spread(setup.tree().links.size()),
        w(setup.tree().links.size()),
        rates(setup.tree().joints.size()),
        setup_(setup),
        qd_(qd) {
    collect(0, base_w);
  }

  std::vector<MassProperties> composite;  // by link, as the next two
  std::vector<Spread> spread;
  std::vector<Vector3> w;         // angular velocity, link axes
  std::vector<OriginRate> rates;  // by joint

 private:
  const Setup& setup_;
  const std::vector<Expression>& qd_;

  void collect(int link, const Vector3& velocity) {
    const auto l = static_cast<std::size_t>(link);
    w[l] = velocity;
    const MassProperties& own = setup_.mass(link);
    spread[l] = {cross(velocity, own.first_moment), spread_of_rigid_body(velocity, own.pseudo_inertia)};
    for (const JointView& joint : setup_.children(link)) {
      const auto j = static_cast<std::size_t>(joint.index), child = static_cast<std::size_t>(joint.child);
      const std::string& name = setup_.link_name(joint.child);
      setup_.trace.section(name, "link " + name + ": velocity and spread");
      const Pose& pose = setup_.pose(joint.index);
      Vector3 turning = to_child(pose.rotation, velocity);
      if (joint.revolute) turning[2] += qd_[j];
      algorithm::name(setup_.trace.graph, turning, name + "_w");
      rates[j] = {cross(velocity, pose.offset), pose.slide * rate_of_z(turning)};
      if (!joint.revolute) rates[j].slide[2] += qd_[j];
      collect(joint.child, turning);
      if (!setup_.parent_matters(joint.child)) continue;
      const Spread seen = to_parent(pose, rates[j], composite[child], spread[child]);
      spread[l].drift += seen.drift;
      spread[l].spread = spread[l].spread + seen.spread;
    }
  }
};

// The wrench that belongs to the change of a joint's own motion field.
Spatial column_wrench(const MassProperties& m, const Spread& body, const Vector3& w, bool revolute) {
  const Vector3 change = rate_of_z(w);
  if (!revolute) return {cross(m.first_moment, change), m.mass * change};
  const Vector3& l = body.drift;
  const Matrix3& k = body.spread;
  const Vector3 moment = multiply(inertia_tensor(m), change), force = cross(change, m.first_moment);
  return {moment + Vector3{-k[0][2], -k[1][2], k[0][0] + k[1][1]}, force + Vector3{-l[1], l[0], Expression()}};
}

Covector row_covector(const MassProperties& m, const Spread& body, bool revolute) {
  const Vector3& l = body.drift;
  const Matrix3& k = body.spread;
  const Vector3 turning{-k[2][0], -k[2][1], k[0][0] + k[1][1]};
  return {unit_wrench(m, revolute), revolute ? turning : Vector3{l[1], -l[0], Expression()}};
}

class Matrix {
 public:
  explicit Matrix(int size) : size_(size), values_(static_cast<std::size_t>(size * size)) {}
  Expression& operator()(int row, int column) { return values_[static_cast<std::size_t>(row + column * size_)]; }
  const std::vector<Expression>& columns() const { return values_; }

 private:
  int size_;
  std::vector<Expression> values_;
};

bool is_revolute(const model::KinematicTree& tree, int joint) {
  return tree.joints[static_cast<std::size_t>(joint)].type == model::JointType::revolute;
}

// Row and column of a joint, as far up as the tree goes.
void fill_joint(const Setup& setup, const Bodies& bodies, int joint, Matrix& c) {
  const model::KinematicTree& tree = setup.tree();
  const int base = tree.floating_base ? 6 : 0;
  const auto link_of = [&](int j) { return static_cast<std::size_t>(tree.joints[static_cast<std::size_t>(j)].child); };
  const std::size_t link = link_of(joint);
  const bool revolute = is_revolute(tree, joint);
  const std::string& name = tree.links[link].name;
  setup.trace.section(
      name, "link " + name + ": row and column of joint " + tree.joints[static_cast<std::size_t>(joint)].name);
  Spatial wrench = column_wrench(bodies.composite[link], bodies.spread[link], bodies.w[link], revolute);
  Covector row = row_covector(bodies.composite[link], bodies.spread[link], revolute);
  c(base + joint, base + joint) = revolute ? wrench.angular[2] : wrench.linear[2];
  int i = joint;
  while (setup.parent_matters(static_cast<int>(link_of(i)))) {
    wrench = to_parent(setup.pose(i), wrench);
    row = to_parent(setup.pose(i), bodies.rates[static_cast<std::size_t>(i)], row);
    i = tree.parent_joint_of(i);
    if (i < 0) break;
    const Vector3& w = bodies.w[link_of(i)];
    const bool turns = is_revolute(tree, i);
    const Vector3& p = turns ? row.momentum.angular : row.momentum.linear;
    c(base + i, base + joint) = turns ? wrench.angular[2] : wrench.linear[2];
    c(base + joint, base + i) = difference_of_products(p[0], w[1], p[1], w[0]) + (turns ? row.drift[2] : Expression());
  }
  if (!tree.floating_base) return;
  const Vector3& w = bodies.w[0];
  const Vector3 turning = cross(row.momentum.angular, w) + row.drift, sliding = cross(row.momentum.linear, w);
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    c(k, base + joint) = wrench.angular[axis];
    c(3 + k, base + joint) = wrench.linear[axis];
    c(base + joint, k) = turning[axis];
    c(base + joint, 3 + k) = sliding[axis];
  }
}

// The base's own motion fields: turning about its axes, sliding along them.
void fill_base(const Setup& setup, const Bodies& bodies, Matrix& c) {
  setup.trace.section(setup.link_name(0), "base: rows and columns");
  const MassProperties& m = bodies.composite[0];
  const Matrix3& spread = bodies.spread[0].spread;
  const Expression trace = spread[0][0] + spread[1][1] + spread[2][2];
  for (int k = 0; k < 3; ++k) {
    Vector3 axis;
    axis[static_cast<std::size_t>(k)] = setup.trace.graph.one();
    const Vector3 change = cross(bodies.w[0], axis);
    Vector3 moment = multiply(inertia_tensor(m), change);
    for (std::size_t r = 0; r < 3; ++r) moment[r] -= spread[r][static_cast<std::size_t>(k)];
    moment[static_cast<std::size_t>(k)] += trace;
    Vector3 force = cross(change, m.first_moment);
    force += cross(axis, bodies.spread[0].drift);
    const Vector3 sliding_moment = cross(m.first_moment, change), sliding_force = m.mass * change;
    for (int r = 0; r < 3; ++r) {
      const auto row = static_cast<std::size_t>(r);
      c(r, k) = moment[row];
      c(3 + r, k) = force[row];
      c(r, 3 + k) = sliding_moment[row];
      c(3 + r, 3 + k) = sliding_force[row];
    }
  }
}

}  // namespace

Program coriolis_matrix(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  const auto qd = trace.joint_input("qd", Role::joint_velocity);
  Spatial velocity;
  if (tree.floating_base) velocity = trace.spatial_input("base_velocity", Role::base_velocity);
  const Setup setup(trace, q, formulation);
  const Bodies bodies(setup, qd, velocity.angular);
  const int size = tree.dof() + (tree.floating_base ? 6 : 0);
  Matrix c(size);
  for (int j = 0; j < tree.dof(); ++j) fill_joint(setup, bodies, j, c);
  if (tree.floating_base) fill_base(setup, bodies, c);
  trace.output("C", Role::matrix, size, size, c.columns());
  return trace.program(name);
}

}  // namespace robcogen::algorithm
