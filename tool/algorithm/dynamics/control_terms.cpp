// Terms that controllers need of the equation of motion H qdd + C qd + g = tau.
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/gravity.h"
#include "algorithm/dynamics/looped_derivatives.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// H times a velocity: the forces that give a robot at rest, without gravity, that acceleration.
Forces momenta(const TracedRobot& robot, const Motion& base_velocity, const std::vector<Expression>& qd) {
  const std::vector<Expression> at_rest(qd.size());
  return newton_euler_forces(robot, base_motion({}, base_velocity, {}), at_rest, qd, nullptr);
}

std::vector<Expression> by_rows(Trace& trace, const Forces& forces) {
  return generalized_forces(trace, forces.base_wrench, forces.tau);
}

// dH/dt v - C v = C' v, where `p` has the momenta: the momentum h of a link and all beyond it has the component S . h
// in the coordinate of its joint, and S, fixed in the link, turns with it: (v x S) . h = S . (h x v).
Forces turning_of_axes(const TracedRobot& robot, const Forces& p) {
  Forces result;
  result.tau.resize(p.tau.size());
  const auto on_link = [&](int link) -> Force {
    const Vector3 &w = p.motions[at(link)].angular.wd, &v = p.motions[at(link)].a;  // accelerated from rest
    const Force& h = p.wrenches[at(link)];
    return {cross(h.moment, w) + cross(h.linear, v), cross(h.linear, w)};
  };
  for (std::size_t link = 0; link < p.motions.size(); ++link) {
    const std::string& name = robot.link_name(static_cast<int>(link));
    for (const Joint& joint : robot.children(static_cast<int>(link))) {
      robot.trace.section(robot.link_name(joint.child), "link ", ": rate of the momentum");
      result.tau[at(joint.index)] = project(joint, on_link(joint.child));
    }
    if (link == 0 && robot.floating()) result.base_wrench = described({name, "turning"}, on_link(0));
  }
  return result;
}

// The same with loops and couplings, whose rates depend on positions: dH/dt v, then less the Coriolis forces.
std::vector<Expression> rate_along_motion(const TracedRobot& robot, const StateInputs& in, const Forces& p) {
  Trace& trace = robot.trace;
  std::vector<Expression> rate = rates_along_motion(trace, by_rows(trace, p), in);
  const std::vector<Expression> coriolis = by_rows(trace, forces_of_velocities(robot, in));
  for (std::size_t k = 0; k < rate.size(); ++k) rate[k] -= coriolis[k];
  return rate;
}

}  // namespace

// With p = H v, dp/dt = dH/dt v + H dv/dt = tau + dH/dt v - (C v + g).
Program generalized_momentum(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  const Forces p = momenta(robot, in.base_velocity, in.qd);
  std::vector<Expression> rate =
      tree.has_closures() ? rate_along_motion(robot, in, p) : by_rows(trace, turning_of_axes(robot, p));
  Forces needed = forces_at_rest(robot, load.gravity);
  add_passive_forces(trace, in, needed.tau);
  const std::vector<Expression> of_gravity = by_rows(trace, needed);
  for (std::size_t k = 0; k < rate.size(); ++k) rate[k] -= of_gravity[k];
  trace.output("p", Role::value, by_rows(trace, p));
  trace.output("rate", Role::value, rate);
  return trace.program(name);
}

// Along q(s), qd = q' ds/dt and qdd = q' dds/dt^2 + q'' (ds/dt)^2 (Bobrow, Dubowsky and Gibson 1985).
Program path_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::acceleration});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  const std::vector<Expression> at_rest(in.qd.size());
  const auto output = [&](const char* term, const Forces& forces) {
    trace.output(term, Role::joint_force, by_coordinate(trace, forces.tau));
  };
  output("a", momenta(robot, {}, in.qd));
  output("b", newton_euler_forces(robot, base_motion({}, {}, {}), in.qd, in.qdd, nullptr));
  output("c", forces_at_rest(robot, load.gravity));
  return trace.program(name);
}

}  // namespace robcogen::algorithm
