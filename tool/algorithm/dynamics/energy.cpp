// Kinetic and potential energy.
#include <functional>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// m v v + 2 v (w x h) + w I w, all about the link's origin.
Expression twice_energy(const MassProperties& m, const Motion& twist, const std::string& link) {
  const Vector3 &w = twist.angular, &v = twist.linear;
  const Vector3 sliding = m.mass * v, twice_h = m.first_moment + m.first_moment;
  const Vector3 momentum = described("p", link, sliding + cross(w, twice_h));
  const Expression linear = dot(v, momentum);
  const Vector3 angular = described("L", link, multiply(inertia_tensor(m), w));
  return linear + dot(w, angular);
}

}  // namespace

Program kinetic_energy(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const TracedRobot robot(trace, in.q, formulation);

  Expression twice;
  const std::function<void(int, const Motion&)> visit = [&](int link, const Motion& twist) {
    twice += twice_energy(robot.mass(link), twist, robot.link_name(link));
    for (const TracedRotor& rotor : rotors_on(robot, link))
      twice += 2.0 * (in.qd[at(rotor.joint)] * dot(rotor.momentum, twist.angular));
    described("2T_sum", robot.link_name(link), twice);
    for (const Joint& joint : robot.children(link)) {
      const std::string& child = robot.link_name(joint.child);
      trace.section(child, "link ", ": velocity and energy");
      const Motion moved = named(child, across_joint(joint, robot.pose(joint.index), twist, in.qd));
      twice += drive_inertia(trace, joint.index) * (in.qd[at(joint.index)] * in.qd[at(joint.index)]);
      visit(joint.child, moved);
    }
  };
  visit(0, in.base_velocity);
  trace.output("T", Role::energy, std::vector<Expression>{0.5 * twice});
  return trace.program(name);
}

Program potential_energy(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, representative);
  const MassProperties body = moving_body(robot, composite_bodies(robot));
  trace.output("V", Role::energy, std::vector<Expression>{-dot(load.gravity, body.first_moment)});
  return trace.program(name);
}

}  // namespace robcogen::algorithm
