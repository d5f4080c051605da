// Centre of mass, its Jacobian and the centroidal momentum matrix, from composite rigid bodies.
#include <utility>
#include <vector>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// The whole robot, for its momentum: the composite bodies by link, all that moves as one body, and its centre of mass.
struct WholeBody {
  explicit WholeBody(const TracedRobot& r)
      : robot(r), composite(composite_bodies(r)), total(moving_body(r, composite)) {
    const std::string& base = robot.tree().links[0].name;
    robot.trace.section(base, "centre of mass");
    if (total.mass.is_zero()) return;
    per_mass = robot.trace.graph.one() / total.mass;
    com = named("", "com", per_mass * total.first_moment);
  }

  const TracedRobot& robot;
  std::vector<MassProperties> composite;
  MassProperties total;
  Expression per_mass;  // 1 / mass; zero without mass
  Vector3 com;
};

// Momentum of the robot when one joint moves at unit rate: about the base origin, in base axes.
Force unit_momentum(const WholeBody& body, int joint) {
  const TracedRobot& robot = body.robot;
  const model::Joint& moving = robot.tree().joints[at(joint)];
  const std::string& link = robot.link_name(moving.child);
  robot.trace.section(link, "link " + link + ": momentum of joint " + moving.name);
  Force momentum = times_subspace(body.composite[at(moving.child)], robot.joint(joint));
  for (int i = joint; i >= 0; i = robot.tree().parent_joint_of(i)) {
    momentum = to_parent(robot.pose(i), momentum);
    momentum.moment += rotor_momentum(robot, joint, robot.tree().joints[at(i)].parent);
    const std::string& seen_from = robot.link_name(robot.tree().joints[at(i)].parent);
    described("L", at_link(moving.name, seen_from), momentum.moment);
    described("p", at_link(moving.name, seen_from), momentum.linear);
  }
  return momentum;
}

// The same when one coordinate moves, with the joints that it moves.
Force unit_momentum(const WholeBody& body, const std::vector<MovedJoint>& moved) {
  return sum_of(moved, [&](int joint) { return unit_momentum(body, joint); });
}

void append(std::vector<Expression>& columns, const Vector3& v) {
  columns.insert(columns.end(), v.element.begin(), v.element.end());
}

// The columns of the Jacobian of the centre of mass, base twist first.
std::vector<Vector3> velocity_columns(const WholeBody& body) {
  Trace& trace = body.robot.trace;
  std::vector<Vector3> columns;
  if (body.robot.floating()) {
    for (std::size_t k = 0; k < 3; ++k) columns.push_back(cross(unit_vector(trace.graph, k), body.com));
    for (std::size_t k = 0; k < 3; ++k) columns.push_back(unit_vector(trace.graph, k));
  }
  for (const std::vector<MovedJoint>& moved : moved_joints(trace))
    columns.push_back(body.per_mass * unit_momentum(body, moved).linear);
  return columns;
}

// The momentum about the centre of mass at unit velocities.
std::vector<Force> momentum_columns(const WholeBody& body) {
  Trace& trace = body.robot.trace;
  const Vector3& first_moment = body.total.first_moment;
  std::vector<Force> columns;
  if (body.robot.floating()) {
    // About the centre of mass, translation has no angular momentum. With the inertia tensor I about the base origin,
    // the tensor about the centre of mass is I + [h]x [com]x.
    const Matrix3 inertia = inertia_tensor(body.total);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 e = unit_vector(trace.graph, k), velocity = cross(e, body.com);
      const Vector3 moment = Vector3{inertia[0][k], inertia[1][k], inertia[2][k]} - cross(first_moment, velocity);
      columns.push_back({moment, cross(e, first_moment)});
    }
    for (std::size_t k = 0; k < 3; ++k) columns.push_back({{}, body.total.mass * unit_vector(trace.graph, k)});
  }
  for (const std::vector<MovedJoint>& moved : moved_joints(trace)) {
    const Force momentum = unit_momentum(body, moved);
    columns.push_back({momentum.moment - cross(body.com, momentum.linear), momentum.linear});
  }
  return columns;
}

// The rate of momentum of a link and all beyond it, about the link's origin; for a fixed base only that of the links
// beyond.
Force momentum_rate(const TracedRobot& robot, const std::vector<LinkMotion>& motions, const StateInputs& in, int link) {
  Force total;
  for (const Joint& joint : robot.children(link))
    total += to_parent(robot.pose(joint.index), momentum_rate(robot, motions, in, joint.child));
  if (robot.is_base(link) && !robot.floating()) return total;
  const std::string& name = robot.link_name(link);
  robot.trace.section(name, "link ", ": rate of momentum");
  const LinkMotion& motion = motions[at(link)];
  total += link_wrench(robot.trace, robot.mass(link), motion, rotor_motions_on(robot, link, in.qd, {}));
  return described({name, "rate"}, total);
}

// What the functions of this file begin with: their state inputs, with the pose of the base if results are in axes of
// the world, and the robot.
struct CentroidalTrace {
  CentroidalTrace(
      const model::KinematicTree& tree,
      const Formulation& formulation,
      CentroidalAxes axes_,
      std::vector<State> before_pose,
      const std::vector<State>& after_pose = {})
      : axes(axes_),
        trace(tree),
        in(trace, with_pose(std::move(before_pose), after_pose)),
        robot(trace, in.q, formulation) {}

  CentroidalAxes axes;
  Trace trace;
  StateInputs in;
  TracedRobot robot;

  // Rotates a vector from axes of the base to those of the results.
  Vector3 turned(const Vector3& v) const {
    return axes == CentroidalAxes::of_world ? multiply(in.base_rotation, v) : v;
  }
  Force turned(const Force& f) const { return {turned(f.moment), turned(f.linear)}; }

 private:
  std::vector<State> with_pose(std::vector<State> list, const std::vector<State>& more) const {
    if (axes == CentroidalAxes::of_world) list.push_back(State::base_pose);
    list.insert(list.end(), more.begin(), more.end());
    return list;
  }
};

// The momentum of a body with this velocity.
Force momentum_of(const MassProperties& body, const Motion& velocity) {
  const Vector3 &w = velocity.angular, &v = velocity.linear, &h = body.first_moment;
  return {multiply(inertia_tensor(body), w) + cross(h, v), body.mass * v + cross(w, h)};
}

// The momentum about the base origin, in base axes.
Force whole_momentum(const CentroidalTrace& f, const WholeBody& body) {
  Force sum;
  if (f.robot.floating()) sum = momentum_of(body.total, f.in.base_velocity);
  const std::vector<std::vector<MovedJoint>> moved = moved_joints(f.robot.trace);
  const std::vector<int> coordinates = f.trace.tree.coordinates();
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const Expression& rate = f.in.qd[at(coordinates[k])];
    const Force unit = unit_momentum(body, moved[k]);
    sum.moment += rate * unit.moment;
    sum.linear += rate * unit.linear;
  }
  return sum;
}

}  // namespace

Program centroidal_momentum_bias(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation,
    CentroidalAxes axes) {
  CentroidalTrace f(tree, formulation, axes, {State::position, State::velocity}, {State::base_velocity});
  const WholeBody body(f.robot);
  const Forces forces = forces_of_velocities(f.robot, f.in);
  Force rate = momentum_rate(f.robot, forces.motions, f.in, 0);
  rate.moment -= cross(body.com, rate.linear);
  f.trace.output("bias", Role::value, f.turned(rate));
  return f.trace.program(name);
}

Program total_mass(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  Expression mass;
  for (const model::Link& link : tree.links)
    if (link.inertia && (tree.floating_base || link.parent_joint >= 0)) mass += trace.lift(link.inertia->mass);
  trace.output("mass", Role::mass, std::vector<Expression>{mass});
  return trace.program(name);
}

Program center_of_mass(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation,
    CentroidalAxes axes) {
  CentroidalTrace f(tree, formulation, axes, {State::position});
  const Vector3 com = f.in.base_position + f.turned(WholeBody(f.robot).com);
  f.trace.output("com", Role::position, std::vector<Expression>{com[0], com[1], com[2]});
  return f.trace.program(name);
}

Program center_of_mass_jacobian(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation,
    CentroidalAxes axes) {
  CentroidalTrace f(tree, formulation, axes, {State::position});
  std::vector<Expression> columns;
  for (const Vector3& column : velocity_columns(WholeBody(f.robot))) append(columns, f.turned(column));
  f.trace.output("J", Role::matrix, 3, static_cast<int>(columns.size() / 3), columns);
  return f.trace.program(name);
}

Program centroidal_momentum_matrix(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation,
    CentroidalAxes axes) {
  CentroidalTrace f(tree, formulation, axes, {State::position});
  std::vector<Expression> columns;
  for (const Force& column : momentum_columns(WholeBody(f.robot))) {
    append(columns, f.turned(column.moment));
    append(columns, f.turned(column.linear));
  }
  f.trace.output("A", Role::matrix, 6, static_cast<int>(columns.size() / 6), columns);
  return f.trace.program(name);
}

Program center_of_mass_velocity(
    const model::KinematicTree& tree,
    const std::string& name,
    const Formulation& formulation) {
  CentroidalTrace f(
      tree, formulation, CentroidalAxes::of_world, {State::position, State::velocity}, {State::base_velocity});
  const WholeBody body(f.robot);
  const Vector3 velocity = f.turned(body.per_mass * whole_momentum(f, body).linear);
  f.trace.output("v", Role::value, std::vector<Expression>{velocity[0], velocity[1], velocity[2]});
  return f.trace.program(name);
}

Program centroidal_momentum(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  CentroidalTrace f(
      tree, formulation, CentroidalAxes::of_world, {State::position, State::velocity}, {State::base_velocity});
  const WholeBody body(f.robot);
  Force momentum = whole_momentum(f, body);
  momentum.moment -= cross(body.com, momentum.linear);
  f.trace.output("h", Role::value, f.turned(momentum));
  return f.trace.program(name);
}

}  // namespace robcogen::algorithm
