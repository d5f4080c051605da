#include "algorithm/dynamics/newton_euler.h"

#include <utility>

#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/kinematics/loop_functions.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// One pass down and up the tree, branch by branch: what a branch needs is computed where it is used.
class Recursion {
 public:
  Recursion(
      const TracedRobot& robot,
      const std::vector<Expression>& qd,
      const std::vector<Expression>& qdd,
      const LoadInputs* loads)
      : robot_(robot), qd_(qd), qdd_(qdd), loads_(loads) {
    result.tau.resize(qd.size());
    result.motions.resize(robot.tree().links.size());
    result.wrenches.resize(robot.tree().links.size());
  }

  Forces result;

  // The wrench that a link and all beyond it need, about the link's origin.
  Force wrench_of(int link, const LinkMotion& motion) {
    Force total;
    result.motions[at(link)] = motion;
    for (const Joint& joint : robot_.children(link)) {
      const Pose& X_PC = robot_.pose(joint.index);
      const std::string& name = robot_.link_name(joint.child);
      robot_.trace.section(name, "link ", ": velocity and acceleration");
      const LinkMotion child = named(name, across_joint(joint, X_PC, motion, qd_, qdd_));
      const Force wrench = wrench_of(joint.child, child);
      result.tau[at(joint.index)] +=
          project(joint, wrench) + drive_inertia(robot_.trace, joint.index) * qdd_[at(joint.index)];
      if (!robot_.parent_matters(joint.child)) continue;
      total += described(in_parent(name), to_parent(X_PC, wrench));
    }
    const bool base = robot_.is_base(link);
    if (base && !robot_.floating()) return total;
    const std::string& name = robot_.link_name(link);
    robot_.trace.section(name, "link ", ": force and moment");
    const bool only_moment = !base && !robot_.parent_matters(link) && feels_only_moment(robot_.parent_joint(link));
    Force own =
        link_wrench(robot_.trace, robot_.mass(link), motion, rotor_motions_on(robot_, link, qd_, qdd_), only_moment);
    if (loads_) robot_.subtract_external(*loads_, link, own);
    for (const TracedRotor& rotor : rotors_on(robot_, link))
      result.tau[at(rotor.joint)] += dot(rotor.momentum, motion.angular.wd);
    total += described({name, "own"}, own);
    result.wrenches[at(link)] = named(name, total);
    return total;
  }

 private:
  const TracedRobot& robot_;
  const std::vector<Expression>&qd_, &qdd_;
  const LoadInputs* loads_;
};

void output(Trace& trace, const Forces& forces) {
  trace.output("tau", Role::joint_force, by_coordinate(trace, forces.tau));
  if (trace.tree.floating_base) trace.output("base_wrench", Role::base_wrench, forces.base_wrench);
}

Program write_forces(Trace& trace, const std::string& name, const Forces& forces) {
  output(trace, forces);
  return trace.program(name);
}

}  // namespace

Forces newton_euler_forces(
    const TracedRobot& robot,
    const LinkMotion& base,
    const std::vector<Expression>& qd,
    const std::vector<Expression>& qdd,
    const LoadInputs* loads) {
  Recursion recursion(robot, qd, qdd, loads);
  recursion.result.base_wrench = recursion.wrench_of(0, described(robot.link_name(0), base));
  return std::move(recursion.result);
}

TracedMotion::TracedMotion(Trace& trace, const StateInputs& in, Loads loads, const Formulation& formulation)
    : load(trace, loads), robot(trace, in.q, formulation) {
  const LinkMotion base = base_motion(in.base_velocity, in.base_acceleration, load.gravity);
  forces = newton_euler_forces(robot, base, in.qd, in.qdd, &load);
  add_passive_forces(trace, in, forces.tau);
}

Forces bias_forces(const TracedRobot& robot, const StateInputs& in, const LoadInputs& loads) {
  const std::vector<Expression> at_rest = robot.trace.accelerations_at_rest();
  return newton_euler_forces(robot, base_motion(in.base_velocity, {}, loads.gravity), in.qd, at_rest, &loads);
}

Forces forces_of_velocities(const TracedRobot& robot, const StateInputs& in) {
  const std::vector<Expression> at_rest = robot.trace.accelerations_at_rest();
  return newton_euler_forces(robot, base_motion(in.base_velocity, {}, {}), in.qd, at_rest, nullptr);
}

std::vector<Expression> missing_forces(Trace& trace, const std::vector<Expression>& tau, const Forces& needed) {
  std::vector<Expression> missing;
  if (trace.tree.floating_base) {
    for (const Expression& e : needed.base_wrench.moment.element) missing.push_back(-e);
    for (const Expression& e : needed.base_wrench.linear.element) missing.push_back(-e);
  }
  const std::vector<Expression> of_coordinates = by_coordinate(trace, needed.tau);
  for (std::size_t k = 0; k < tau.size(); ++k) missing.push_back(tau[k] - of_coordinates[k]);
  return missing;
}

void trace_newton_euler(Trace& trace, Loads loads, const Formulation& formulation) {
  const StateInputs in = motion_inputs(trace);
  output(trace, TracedMotion(trace, in, loads, formulation).forces);
}

Program newton_euler(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  trace_newton_euler(trace, loads, formulation);
  return trace.program(name);
}

Program bias_forces(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  Forces forces = bias_forces(robot, in, load);
  add_passive_forces(trace, in, forces.tau);
  return write_forces(trace, name, forces);
}

Program coriolis_forces(const model::KinematicTree& tree, const std::string& name, const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const TracedRobot robot(trace, in.q, formulation);
  return write_forces(trace, name, forces_of_velocities(robot, in));
}

Program inverse_dynamics_gradient(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  const Program forces = newton_euler(tree, name, loads, formulation);
  std::vector<std::string> outputs = {"tau"}, inputs = {"q", "qd", "qdd"};
  if (tree.floating_base) {
    outputs = {"base_wrench", "tau"};
    inputs.insert(inputs.end(), {"base_velocity", "base_acceleration"});
  }
  return symbolic::with_gradient(
      forces, {{"weights", outputs}}, inputs, symbolic::place_of_loads(forces), follower_rates(tree));
}

Program inverse_dynamics_second_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  std::vector<std::pair<std::string, std::string>> pairs = {{"q", "q"}, {"qd", "q"}, {"qdd", "q"}, {"qd", "qd"}};
  if (tree.floating_base)
    pairs.insert(
        pairs.end(), {{"base_velocity", "q"},
                      {"base_acceleration", "q"},
                      {"base_velocity", "qd"},
                      {"base_velocity", "base_velocity"}});
  return symbolic::with_second_derivatives(
      inverse_dynamics_gradient(tree, name, loads, formulation), pairs, derivative_mode(formulation),
      follower_rates(tree));
}

}  // namespace robcogen::algorithm
