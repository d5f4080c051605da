// Centre of mass, its Jacobian and the centroidal momentum matrix, from composite rigid bodies.
#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/describe.h"

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
    com = per_mass * total.first_moment;
    name(robot.trace.graph, com, "com_");
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
    describe(momentum.moment, moving.name + "_" + seen_from + "_L");
    describe(momentum.linear, moving.name + "_" + seen_from + "_p");
  }
  return momentum;
}

// The same when one coordinate moves, with the joints that it moves.
Force unit_momentum(const WholeBody& body, const std::vector<Share>& moved) {
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
  for (const std::vector<Share>& moved : shares(trace))
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
  for (const std::vector<Share>& moved : shares(trace)) {
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
  total += link_wrench(robot.trace, robot.mass(link), motion, spins_on(robot, link, in.qd, {}));
  describe(total, name + "_rate");
  return total;
}

// The inputs of a function, with the pose of the base if its results are in axes of the world.
std::vector<State> with_pose(CentroidalAxes axes, std::vector<State> list, const std::vector<State>& more = {}) {
  if (axes == CentroidalAxes::of_world) list.push_back(State::base_pose);
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

// Rotates a vector from axes of the base to those of the results.
Vector3 turned(CentroidalAxes axes, const StateInputs& in, const Vector3& v) {
  return axes == CentroidalAxes::of_world ? multiply(in.base_rotation, v) : v;
}

// Calls add(velocity, its column) for each velocity, base twist first.
template <class Column, class Add>
void for_each_velocity(const StateInputs& in, const Trace& trace, const std::vector<Column>& columns, const Add& add) {
  std::vector<Expression> velocities;
  if (trace.tree.floating_base)
    for (const Vector3& part : {in.base_velocity.angular, in.base_velocity.linear})
      velocities.insert(velocities.end(), part.element.begin(), part.element.end());
  for (const int joint : trace.tree.coordinates()) velocities.push_back(in.qd[at(joint)]);
  for (std::size_t k = 0; k < columns.size(); ++k) add(velocities[k], columns[k]);
}

}  // namespace

Program centroidal_momentum_bias(
    const model::KinematicTree& tree,
    const std::string& name,
    const RepresentativeLinks& representative,
    CentroidalAxes axes) {
  Trace trace(tree);
  const StateInputs in(trace, with_pose(axes, {State::position, State::velocity}, {State::base_velocity}));
  const TracedRobot robot(trace, in.q, representative);
  const WholeBody body(robot);
  const std::vector<Expression> at_rest = trace.accelerations_at_rest();
  const Forces forces = newton_euler_forces(robot, base_motion(in.base_velocity, {}, {}), in.qd, at_rest, nullptr);
  Force rate = momentum_rate(robot, forces.motions, in, 0);
  rate.moment -= cross(body.com, rate.linear);
  trace.output("bias", Role::value, Force{turned(axes, in, rate.moment), turned(axes, in, rate.linear)});
  return trace.program(name);
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
    const RepresentativeLinks& representative,
    CentroidalAxes axes) {
  Trace trace(tree);
  const StateInputs in(trace, with_pose(axes, {State::position}));
  const TracedRobot robot(trace, in.q, representative);
  const Vector3 com = in.base_position + turned(axes, in, WholeBody(robot).com);
  trace.output("com", Role::position, std::vector<Expression>{com[0], com[1], com[2]});
  return trace.program(name);
}

Program center_of_mass_jacobian(
    const model::KinematicTree& tree,
    const std::string& name,
    const RepresentativeLinks& representative,
    CentroidalAxes axes) {
  Trace trace(tree);
  const StateInputs in(trace, with_pose(axes, {State::position}));
  const TracedRobot robot(trace, in.q, representative);
  std::vector<Expression> columns;
  for (const Vector3& column : velocity_columns(WholeBody(robot))) append(columns, turned(axes, in, column));
  trace.output("J", Role::matrix, 3, static_cast<int>(columns.size() / 3), columns);
  return trace.program(name);
}

Program centroidal_momentum_matrix(
    const model::KinematicTree& tree,
    const std::string& name,
    const RepresentativeLinks& representative,
    CentroidalAxes axes) {
  Trace trace(tree);
  const StateInputs in(trace, with_pose(axes, {State::position}));
  const TracedRobot robot(trace, in.q, representative);
  std::vector<Expression> columns;
  for (const Force& column : momentum_columns(WholeBody(robot))) {
    append(columns, turned(axes, in, column.moment));
    append(columns, turned(axes, in, column.linear));
  }
  trace.output("A", Role::matrix, 6, static_cast<int>(columns.size() / 6), columns);
  return trace.program(name);
}

Program center_of_mass_velocity(
    const model::KinematicTree& tree,
    const std::string& name,
    const RepresentativeLinks& representative) {
  Trace trace(tree);
  const auto axes = CentroidalAxes::of_world;
  const StateInputs in(trace, with_pose(axes, {State::position, State::velocity}, {State::base_velocity}));
  const TracedRobot robot(trace, in.q, representative);
  Vector3 sum;
  for_each_velocity(in, trace, velocity_columns(WholeBody(robot)), [&](const Expression& v, const Vector3& column) {
    sum += v * column;
  });
  const Vector3 velocity = turned(axes, in, sum);
  trace.output("v", Role::value, std::vector<Expression>{velocity[0], velocity[1], velocity[2]});
  return trace.program(name);
}

Program centroidal_momentum(
    const model::KinematicTree& tree,
    const std::string& name,
    const RepresentativeLinks& representative) {
  Trace trace(tree);
  const auto axes = CentroidalAxes::of_world;
  const StateInputs in(trace, with_pose(axes, {State::position, State::velocity}, {State::base_velocity}));
  const TracedRobot robot(trace, in.q, representative);
  Force sum;
  for_each_velocity(in, trace, momentum_columns(WholeBody(robot)), [&](const Expression& v, const Force& column) {
    sum.moment += v * column.moment;
    sum.linear += v * column.linear;
  });
  trace.output("h", Role::value, Force{turned(axes, in, sum.moment), turned(axes, in, sum.linear)});
  return trace.program(name);
}

}  // namespace robcogen::algorithm
