// Integration of positions, and the way between two of them, with spherical joints.
//
// There are no branches: the length of a vector that may vanish is that with a fourth component of 1e-18, which is lost
// in rounding for any other vector.
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/spatial/trace.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

struct Quaternion {
  Expression w;
  Vector3 v;
};

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}

// The quaternion of a spherical joint in positions as Trace::joint_input gives them: all joints, then the scalar parts.
Quaternion quaternion_of(const std::vector<Expression>& q, std::size_t joints, int first, std::size_t number) {
  const std::size_t x = at(first);
  return {q[joints + number], {q[x], q[x + 1], q[x + 2]}};
}

Expression length(Trace& trace, const Vector3& v) {
  constexpr double kLeastSquare = 1e-36;
  return sqrt(dot(v, v) + trace.graph.constant(kLeastSquare));
}

}  // namespace

Program integrate_positions(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  const std::vector<Expression> qd = trace.joint_input("qd", Role::joint_velocity);
  const std::vector<int> elements = tree.position_elements(), balls = tree.spherical_joints();
  std::vector<Expression> moved(at(tree.dof()) + balls.size());
  for (const int joint : tree.coordinates()) moved[at(elements[at(joint)])] = q[at(joint)] + qd[at(joint)];
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const std::size_t x = at(balls[k]);
    const std::string& ball = tree.joints[x].declared_name();
    trace.section(ball, "joint ", ": rotation");
    const Vector3 half = trace.graph.constant(0.5) * Vector3{qd[x], qd[x + 1], qd[x + 2]};
    const Expression angle = length(trace, half);
    const Quaternion turn = {cos(angle), (sin(angle) / angle) * half};
    const Quaternion end = product(quaternion_of(q, tree.joints.size(), balls[k], k), turn);
    const Expression scale = trace.graph.one() / sqrt(end.w * end.w + dot(end.v, end.v));
    const std::size_t first = at(elements[x]) - 1;
    moved[first] = scale * end.w;
    for (std::size_t i = 0; i < 3; ++i) moved[first + 1 + i] = scale * end.v[i];
  }
  trace.output("positions", Role::value, moved);
  return trace.program(name);
}

Program position_difference(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> from = trace.joint_input("q_from", Role::joint_position);
  const std::vector<Expression> to = trace.joint_input("q_to", Role::joint_position);
  const std::vector<int> balls = tree.spherical_joints();
  std::vector<Expression> way(tree.joints.size());
  for (const int joint : tree.coordinates()) way[at(joint)] = to[at(joint)] - from[at(joint)];
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const std::string& ball = tree.joints[at(balls[k])].declared_name();
    trace.section(ball, "joint ", ": rotation");
    const Quaternion start = quaternion_of(from, tree.joints.size(), balls[k], k);
    const Quaternion turn = product({start.w, -start.v}, quaternion_of(to, tree.joints.size(), balls[k], k));
    // The arc tangent of the whole angle, which is the shorter way whatever the signs of the quaternions.
    const Expression sine = length(trace, turn.v), twice = turn.w + turn.w;
    const Expression angle = atan2(twice * sine, turn.w * turn.w - dot(turn.v, turn.v));
    const Vector3 ways = (angle / sine) * turn.v;
    for (std::size_t i = 0; i < 3; ++i) way[at(balls[k]) + i] = ways[i];
  }
  std::vector<Expression> velocities;
  for (const int joint : tree.coordinates()) velocities.push_back(way[at(joint)]);
  trace.output("qd", Role::joint_velocity, velocities);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
