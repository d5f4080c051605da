// Gravity forces from the first moments of composite bodies: half the work of a Newton-Euler pass at rest.
#include "algorithm/dynamics/gravity.h"

#include <functional>

#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/looped_derivatives.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// Mass and first moment about the link's origin.
struct PointMass {
  Expression mass;
  Vector3 moment;
};

// The wrench that gives the body an acceleration.
Force wrench_of(const PointMass& body, const Vector3& a) {
  return {cross(body.moment, a), body.mass * a};
}

// Forces of a robot at rest, and what they follow from.
struct RobotAtRest {
  std::vector<Vector3> a;       // by link: -g in link axes
  std::vector<PointMass> body;  // by link: the link and all beyond it, about its origin
  std::vector<Expression> tau;
};

// Passes accelerations down the tree, and collects masses and first moments on the way up.
RobotAtRest robot_at_rest(const TracedRobot& robot, const Vector3& gravity) {
  RobotAtRest rest;
  rest.a.resize(robot.tree().links.size());
  rest.body.resize(robot.tree().links.size());
  rest.tau.resize(robot.tree().joints.size());
  Trace& trace = robot.trace;
  const std::function<PointMass(int, const Vector3&)> visit = [&](int link, const Vector3& a) {
    rest.a[at(link)] = a;
    PointMass total{robot.mass(link).mass, robot.mass(link).first_moment};
    for (const Joint& joint : robot.children(link)) {
      const std::string& child = robot.link_name(joint.child);
      const Pose& X_PC = robot.pose(joint.index);
      trace.section(child, "link ", ": gravity and first moment");
      const Vector3 a_C = named("a", child, to_child(X_PC.rotation, a));
      PointMass body = visit(joint.child, a_C);
      named("h", child, body.moment);
      rest.tau[at(joint.index)] = project(joint, wrench_of(body, a_C));
      body.moment[2] += body.mass * X_PC.slide;
      const Vector3 turned = described("h", in_parent(child), to_parent(X_PC.rotation, body.moment));
      total.moment += turned + body.mass * X_PC.offset;
      total.mass += body.mass;
    }
    rest.body[at(link)] = total;
    return total;
  };
  visit(0, -gravity);
  return rest;
}

}  // namespace

Forces forces_at_rest(const TracedRobot& robot, const Vector3& gravity) {
  const RobotAtRest rest = robot_at_rest(robot, gravity);
  Forces forces;
  forces.tau = rest.tau;
  if (robot.floating()) forces.base_wrench = wrench_of(rest.body[0], -gravity);
  return forces;
}

Program gravity_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  const Forces forces = forces_at_rest(robot, load.gravity);
  trace.output("tau", Role::joint_force, by_coordinate(trace, forces.tau));
  if (tree.floating_base) trace.output("base_wrench", Role::base_wrench, forces.base_wrench);
  return trace.program(name);
}

namespace {

// Whether the motions of two joints commute: turns about two axes of a spherical joint do not.
bool commute(const model::KinematicTree& tree, int a, int b) {
  return a == b || tree.joints[at(a)].spherical.empty() || tree.joints[at(a)].spherical != tree.joints[at(b)].spherical;
}

// With dependent joints of loops, by the chain rule (looped_derivatives.h).
Program looped_gravity_derivative(
    Trace& trace,
    const StateInputs& in,
    const LoadInputs& load,
    const RobotAtRest& rest,
    const std::string& name) {
  const model::KinematicTree& tree = trace.tree;
  const Force wrench = tree.floating_base ? wrench_of(rest.body[0], -load.gravity) : Force();
  const std::vector<Expression> of = generalized_forces(trace, wrench, rest.tau);
  Columns d_q = derivatives_by_positions(trace, of, in.q);
  const std::vector<int> coordinates = tree.coordinates();
  const std::size_t n = coordinates.size(), base = of.size() - n;
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = r + 1; c < n; ++c)
      if (commute(tree, coordinates[r], coordinates[c])) d_q[c][base + r] = d_q[r][base + c];
  const int rows = static_cast<int>(of.size());
  trace.output("d_q", Role::matrix, rows, d_q);
  if (!tree.floating_base) return trace.program(name);
  trace.section(tree.links[0].name, "derivatives by rotation of the base");
  Columns d_base;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 change = cross(load.gravity, unit_vector(trace.graph, k));
    std::vector<symbolic::Rate> changes;
    for (std::size_t i = 0; i < 3; ++i) changes.push_back({load.gravity[i], change[i]});
    d_base.push_back(symbolic::rates_of(of, changes));
  }
  trace.output("d_base_rotation", Role::matrix, rows, d_base);
  return trace.program(name);
}

}  // namespace

// The potential is minus gravity times the first moment of the whole robot. Per unit of a joint's position, the moment
// changes by f, the linear force of a unit acceleration of the joint. So tau = f . a, with a = -g in link axes, and the
// derivatives follow from the rotation of a.
Program gravity_forces_derivative(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  const RobotAtRest rest = robot_at_rest(robot, load.gravity);
  if (tree.has_closures()) return looped_gravity_derivative(trace, in, load, rest, name);
  const int base = tree.floating_base ? 6 : 0, joints = static_cast<int>(tree.joints.size());
  const std::vector<Expression> zeros(at(base + joints));
  Columns d_q(at(joints), zeros), d_base(3, zeros);
  for (int j = 0; j < joints; ++j) {
    const std::size_t column = at(j);
    Joint joint = robot.joint(j);
    trace.section(robot.link_name(joint.child), "derivatives of joint " + tree.joints[column].name);
    const PointMass& body = rest.body[at(joint.child)];
    const auto force_of = [&](const Joint& moving) {
      return times_subspace(MassProperties{body.mass, body.moment, {}}, moving).linear;
    };
    const auto slip_of = [&](const Joint& moving) {
      return cross(rest.a[at(moving.child)], subspace(moving, trace.graph).angular);
    };
    const Joint own = joint;
    Vector3 f = force_of(own);
    while (true) {
      d_q[column][at(base + joint.index)] = d_q[at(joint.index)][at(base + j)] = dot(f, slip_of(joint));
      if (!commute(tree, joint.index, j)) d_q[column][at(base + joint.index)] = dot(force_of(joint), slip_of(own));
      if (!robot.parent_matters(joint.child)) break;
      f = to_parent(robot.pose(joint.index).rotation, f);
      const int parent = tree.parent_joint_of(joint.index);
      if (parent < 0) break;
      joint = robot.joint(parent);
    }
    if (!tree.floating_base) continue;
    const Vector3 moment = cross(f, rest.a[0]);
    for (std::size_t k = 0; k < 3; ++k) d_q[column][k] = d_base[k][at(base) + column] = moment[k];
  }
  const int rows = base + tree.dof();
  d_q = by_coordinate(trace, d_q, base);
  const std::vector<int> coordinates = tree.coordinates();
  // Both triangles are made equal: sums over couplings in another order would round differently.
  for (int r = 0; r < tree.dof(); ++r)
    for (int c = r + 1; c < tree.dof(); ++c)
      if (commute(tree, coordinates[at(r)], coordinates[at(c)])) d_q[at(c)][at(base + r)] = d_q[at(r)][at(base + c)];
  trace.output("d_q", Role::matrix, rows, d_q);
  if (!tree.floating_base) return trace.program(name);
  for (std::size_t k = 0; k < 3; ++k) {
    const Force change = wrench_of(rest.body[0], cross(rest.a[0], unit_vector(trace.graph, k)));
    for (std::size_t i = 0; i < 3; ++i) {
      d_base[k][i] = change.moment[i];
      d_base[k][3 + i] = change.linear[i];
    }
  }
  trace.output("d_base_rotation", Role::matrix, rows, rows_by_coordinate(trace, d_base, base));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
