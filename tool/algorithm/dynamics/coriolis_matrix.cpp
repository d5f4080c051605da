// The Coriolis matrix, from the moments of the velocities of composite bodies (moment_rates.h).
//
// With C_ij = integral of u_i (du_j/dt) dm, dH/dt - 2 C is skew symmetric, because H_ij = integral of u_i u_j dm.
//
// A rotor has the momentum p per unit rate of its joint, fixed in its carrier. About the carrier, it adds w x p to the
// wrench of the column, and p to the factor of a_w' in the row.
#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/moment_rates.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// Fills the row and the column of a joint, up to the base.
void fill_joint(const TracedRobot& robot, const CompositeMotion& bodies, int index, SquareMatrix& c) {
  const model::KinematicTree& tree = robot.tree();
  const int base = tree.floating_base ? 6 : 0;
  Joint joint = robot.joint(index);
  const std::size_t link = at(joint.child);
  const std::string& name = tree.links[link].name;
  robot.trace.section(name, "link " + name + ": row and column of joint " + tree.joints[at(index)].name);
  const Motion S = subspace(joint, robot.trace.graph);
  Force wrench = column_wrench(bodies.composite[link], bodies.moment_rates[link], bodies.w[link], S);
  ChangeOfMotion row = row_of_joint(bodies.composite[link], bodies.moment_rates[link], joint, S);
  c(base + index, base + index) = project(joint, wrench);
  const std::string& moving = tree.joints[at(index)].name;
  const auto describe_all = [&](const std::string& link_name) {
    described(at_link(moving, link_name), wrench);
    described(at_link(moving, link_name, "Q"), row.Q);
    described("e", at_link(moving, link_name), row.e);
  };
  describe_all(name);
  const RotorPath path = rotor_path(tree, index);
  while (robot.parent_matters(joint.child)) {
    const Pose& X_PC = robot.pose(joint.index);
    wrench = to_parent(X_PC, wrench);
    row = to_parent(X_PC, bodies.rates[at(joint.index)], row);
    const int reached = tree.joints[at(joint.index)].parent;
    if (reached == path.end) {
      const Vector3 momentum = rotor_momentum(robot, index);
      wrench.moment += to_end(robot, path, cross(bodies.w[at(path.carrier)], momentum));
      row.Q.moment += to_end(robot, path, momentum);
    }
    const int parent = tree.parent_joint_of(joint.index);
    if (parent < 0) break;
    joint = robot.joint(parent);
    c(base + parent, base + index) = project(joint, wrench);
    c(base + index, base + parent) = project(joint, on_fields_of_link(row, bodies.w[at(joint.child)]));
    described(coordinates("C", tree.joints[at(parent)].name, moving), c(base + parent, base + index));
    described(coordinates("C", moving, tree.joints[at(parent)].name), c(base + index, base + parent));
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
      described(coordinates("C", coordinate, moving), c(r, base + index));
      described(coordinates("C", moving, coordinate), c(base + index, r));
    }
  }
}

// Fills the elements of the joints that a rotor's momentum passes on its way to the links that carry the rotor's own
// joint.
void add_rotor_path(const TracedRobot& robot, const CompositeMotion& bodies, int index, SquareMatrix& c) {
  const RotorPath path = rotor_path(robot.tree(), index);
  if (path.joints.empty()) return;
  const int base = robot.tree().floating_base ? 6 : 0;
  Vector3 momentum = rotor_momentum(robot, index);
  Vector3 rate = cross(bodies.w[at(path.carrier)], momentum);
  for (const int passed : path.joints) {
    const Joint joint = robot.joint(passed);
    const ChangeOfMotion row{{momentum, {}}, {}};
    c(base + passed, base + index) += project(joint, Force{rate, {}});
    c(base + index, base + passed) += project(joint, on_fields_of_link(row, bodies.w[at(joint.child)]));
    momentum = to_parent(robot.pose(passed).rotation, momentum);
    rate = to_parent(robot.pose(passed).rotation, rate);
  }
}

// Fills the rows and columns of the base's own motion fields: rotation about its axes and translation along them.
void fill_base(const TracedRobot& robot, const CompositeMotion& bodies, SquareMatrix& c) {
  robot.trace.section(robot.link_name(0), "base: rows and columns");
  const MassProperties& m = bodies.composite[0];
  const Matrix3& K = bodies.moment_rates[0].K;
  const Expression trace = K[0][0] + K[1][1] + K[2][2];
  for (int k = 0; k < 3; ++k) {
    const Vector3 axis = unit_vector(robot.trace.graph, at(k));
    const Vector3 change = cross(bodies.w[0], axis);
    Vector3 moment = multiply(inertia_tensor(m), change);
    for (std::size_t r = 0; r < 3; ++r) moment[r] -= K[r][at(k)];
    moment[at(k)] += trace;
    Vector3 force = cross(change, m.first_moment);
    force += cross(axis, bodies.moment_rates[0].l);
    const Vector3 sliding_moment = cross(m.first_moment, change), sliding_force = m.mass * change;
    for (int r = 0; r < 3; ++r) {
      const auto row = at(r);
      c(r, k) = moment[row];
      c(3 + r, k) = force[row];
      c(r, 3 + k) = sliding_moment[row];
      c(3 + r, 3 + k) = sliding_force[row];
      const std::vector<std::string> names = coordinate_names(robot.tree());
      for (const int i : {r, 3 + r})
        for (const int j : {k, 3 + k}) described(coordinates("C", names[at(i)], names[at(j)]), c(i, j));
    }
  }
}

}  // namespace

Program coriolis_matrix(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const TracedRobot robot(trace, in.q, formulation);
  const CompositeMotion bodies(robot, in.qd, in.base_velocity.angular);
  const int base = tree.floating_base ? 6 : 0, joints = static_cast<int>(tree.joints.size());
  SquareMatrix c(base + joints);
  for (int j = 0; j < joints; ++j) fill_joint(robot, bodies, j, c);
  for (int j = 0; j < joints; ++j) add_rotor_path(robot, bodies, j, c);
  if (tree.floating_base) fill_base(robot, bodies, c);
  // The inertias of joints are parts of the rows above and take no further operations.
  c = tree.has_closures() ? coriolis_by_coordinate(trace, c, inertia_by_joint(robot), in.qd, base)
                          : by_coordinate(trace, c, base, Symmetry::none);
  const int size = c.size();
  trace.output("C", Role::matrix, size, size, c.columns());
  return trace.program(name);
}

}  // namespace robcogen::algorithm
