#include "algorithm/dynamics/looped_derivatives.h"

#include <algorithm>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/spatial/couplings.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Rate;

// Adds the rates of a unit quaternion for a turn t about an axis of the child of a spherical joint: q (1, t / 2).
void add_turn(Trace& trace, const std::vector<Expression>& q, int component, std::vector<Rate>& changes) {
  const model::KinematicTree& tree = trace.tree;
  const std::vector<int> balls = tree.spherical_joints();
  const int first = tree.first_component_of(component);
  std::size_t number = 0;
  while (balls[number] != first) ++number;
  const std::size_t axis = at(component - first);
  const auto part = [&](std::size_t k) -> const Expression& { return q[at(first) + k % 3]; };
  const Expression &scalar = q[tree.joints.size() + number], half = trace.graph.constant(0.5);
  changes.push_back({scalar, -(half * part(axis))});
  changes.push_back({part(axis), half * scalar});
  changes.push_back({part(axis + 1), half * part(axis + 2)});
  changes.push_back({part(axis + 2), -(half * part(axis + 1))});
}

// The changes of positions for a unit motion of a coordinate.
std::vector<Rate> position_changes(Trace& trace, const std::vector<Expression>& q, int joint) {
  const model::KinematicTree& tree = trace.tree;
  std::vector<Rate> changes;
  if (tree.joints[at(joint)].type == model::JointType::spherical)
    add_turn(trace, q, joint, changes);
  else
    changes.push_back({q[at(joint)], trace.graph.one()});
  for (const int dependent : tree.followers_in_q())
    for (const RateTerm& share : trace.rates_of(*tree.coupling_of(dependent)))
      if (share.joint == joint) changes.push_back({q[at(dependent)], share.factor});
  return changes;
}

void append(std::vector<Rate>& changes, const std::vector<Rate>& more) {
  changes.insert(changes.end(), more.begin(), more.end());
}

bool is_multiple_by_constant(Trace& trace, const Expression& e) {
  if (e.is_constant()) return false;
  const symbolic::Node node = trace.graph.nodes()[at(e.node())];
  return node.kind == symbolic::Node::Kind::operation && node.op == symbolic::Op::multiply &&
         (trace.graph.expression(node.a, false).is_constant() || trace.graph.expression(node.b, false).is_constant());
}

}  // namespace

std::vector<Expression> generalized_forces(Trace& trace, const Force& base_wrench, const std::vector<Expression>& tau) {
  std::vector<Expression> all;
  if (trace.tree.floating_base)
    for (const Vector3& part : {base_wrench.moment, base_wrench.linear})
      all.insert(all.end(), part.element.begin(), part.element.end());
  const std::vector<Expression> reduced = by_coordinate(trace, tau);
  all.insert(all.end(), reduced.begin(), reduced.end());
  return all;
}

Columns derivatives_by_positions(
    Trace& trace,
    const std::vector<Expression>& of,
    const std::vector<Expression>& q,
    const std::vector<Rate>& held) {
  Columns columns;
  for (const int joint : trace.tree.coordinates()) {
    const std::string& name = trace.tree.joints[at(joint)].name;
    trace.section("dq_" + name, "derivatives by the position of joint " + name);
    std::vector<Rate> changes = position_changes(trace, q, joint);
    append(changes, held);
    columns.push_back(symbolic::rates_of(of, changes));
  }
  return columns;
}

std::vector<Expression> rates_along_motion(Trace& trace, const std::vector<Expression>& of, const StateInputs& in) {
  std::vector<Rate> changes;
  for (const int joint : trace.tree.coordinates()) {
    for (const Rate& change : position_changes(trace, in.q, joint)) {
      const auto known = std::find_if(
          changes.begin(), changes.end(), [&](const Rate& other) { return other.of.node() == change.of.node(); });
      const Expression rate = change.rate * in.qd[at(joint)];
      if (known == changes.end())
        changes.push_back({change.of, rate});
      else
        known->rate += rate;
    }
  }
  return symbolic::rates_of(of, changes);
}

std::vector<Expression> derivative_by_velocity(
    Trace& trace,
    const std::vector<Expression>& of,
    const Expression& velocity,
    std::vector<Rate> held) {
  held.insert(held.begin(), {velocity, trace.graph.one()});
  return symbolic::rates_of(of, held);
}

Columns derivatives_by_velocities(
    Trace& trace,
    const std::vector<Expression>& of,
    const std::vector<Expression>& qd,
    const std::vector<Rate>& held) {
  Columns columns;
  for (const int joint : trace.tree.coordinates()) {
    const std::string& name = trace.tree.joints[at(joint)].name;
    trace.section("dqd_" + name, "derivatives by the velocity of joint " + name);
    columns.push_back(derivative_by_velocity(trace, of, qd[at(joint)], held));
  }
  return columns;
}

std::vector<Expression> held_apart(Trace& trace, const std::vector<Expression>& results) {
  if (!trace.tree.has_closures()) return results;
  const Expression two = trace.graph.constant(2.0);  // doubling and halving is exact, and a quotient does not fold
  std::vector<Expression> apart;
  for (const Expression& result : results)
    apart.push_back(is_multiple_by_constant(trace, result) ? (two * result) / two : result);
  return apart;
}

std::vector<Rate> held_accelerations(const model::KinematicTree& tree, const StateInputs& in) {
  std::vector<Rate> held;
  for (const int joint : tree.coordinates()) held.push_back({in.qdd[at(joint)], Expression()});
  for (const Vector3& part : {in.base_acceleration.angular, in.base_acceleration.linear})
    for (const Expression& e : part.element) held.push_back({e, Expression()});
  return held;
}

ForceDerivatives looped_force_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const Vector3& gravity,
    const Forces& forces) {
  Trace& trace = robot.trace;
  const std::vector<Expression> of = generalized_forces(trace, forces.base_wrench, forces.tau);
  const std::vector<Rate> held = held_accelerations(trace.tree, in);
  ForceDerivatives d;
  d.q = derivatives_by_positions(trace, of, in.q, held);
  d.qd = derivatives_by_velocities(trace, of, in.qd, held);
  const SquareMatrix H = joint_space_inertia(robot);
  const int base = robot.floating() ? 6 : 0;
  for (int c = 0; c < H.size(); ++c) {
    std::vector<Expression>& column = (c < base ? d.base_acceleration : d.qdd).emplace_back();
    for (int r = 0; r < H.size(); ++r) column.push_back(H(r, c));
  }
  if (!robot.floating()) return d;
  trace.section(robot.link_name(0), "base: derivatives");
  for (std::size_t k = 0; k < 3; ++k)
    d.base_velocity.push_back(derivative_by_velocity(trace, of, in.base_velocity.angular[k], held));
  fill_free_columns(gravity, in.base_velocity.angular, d);
  return d;
}

}  // namespace robcogen::algorithm
