// Inverse dynamics of a robot whose base nothing holds (Featherstone 2008, sec. 9.4).
#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/newton_euler.h"

namespace robcogen::algorithm {

using symbolic::Role;

symbolic::Program unactuated_base_inverse_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::acceleration, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  // The motion with a base that does not accelerate needs a wrench on the base that nothing supplies …
  const LinkMotion base = base_motion(in.base_velocity, {}, load.gravity);
  const Forces forces = newton_euler_forces(robot, base, in.qd, in.qdd, &load);
  // … so the whole robot accelerates like one rigid body by the wrench that is missing.
  const std::vector<MassProperties> composite = composite_bodies(robot);
  trace.section(tree.links[0].name, "base: acceleration");
  const Motion acceleration = free_acceleration(rigid_body_inertia(composite[0]), forces.base_wrench);
  algorithm::name(trace.graph, acceleration.angular, "base_acceleration_w");
  algorithm::name(trace.graph, acceleration.linear, "base_acceleration_v");
  std::vector<Expression> tau = forces.tau;
  add_composite_forces(robot, composite, acceleration, tau);
  add_passive_forces(trace, in, tau);
  trace.output("tau", Role::joint_force, tau);
  trace.output("base_acceleration", Role::base_acceleration, acceleration);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
