// Forward dynamics by articulated bodies, or by solving with the joint-space inertia matrix.
#include <algorithm>

#include "algorithm/dynamics/articulated_body.h"
#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/dynamics/newton_euler.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Role;

// H qdd = tau - bias, eliminated from the leaves (Featherstone 2008, sec. 6.5, without square roots).
ForwardMotion by_inertia_matrix(const TracedRobot& robot, const StateInputs& in, const LoadInputs& load) {
  const model::KinematicTree& tree = robot.tree();
  const Forces bias = bias_forces(robot, in, load);
  const SquareMatrix H = joint_space_inertia(robot);
  const std::vector<int> order = elimination_order(tree);
  const int base = tree.floating_base ? 6 : 0, size = H.size();
  std::vector<Expression> missing;
  if (tree.floating_base) {
    for (const Expression& e : bias.base_wrench.moment.element) missing.push_back(-e);
    for (const Expression& e : bias.base_wrench.linear.element) missing.push_back(-e);
  }
  robot.trace.section("solution", "solution with the joint-space inertia matrix");
  for (std::size_t j = 0; j < in.tau.size(); ++j) missing.push_back(in.tau[j] - bias.tau[j]);
  SquareMatrix a(size);
  std::vector<Expression> b;
  std::vector<std::string> names = coordinate_names(tree), ordered;
  for (const int k : order) ordered.push_back(names[at(k)]);
  for (int r = 0; r < size; ++r) {
    for (int c = 0; c < size; ++c) a(r, c) = H(order[at(r)], order[at(c)]);
    b.push_back(missing[at(order[at(r)])]);
  }
  const std::vector<Expression> solution = solve(std::move(a), std::move(b), ordered);
  std::vector<Expression> x(at(size));
  for (std::size_t r = 0; r < solution.size(); ++r) x[at(order[r])] = solution[r];
  ForwardMotion motion;
  if (tree.floating_base) motion.base_acceleration = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  motion.qdd.assign(x.begin() + base, x.end());
  return motion;
}

}  // namespace

bool allows_articulated_bodies(const model::KinematicTree& tree) {
  return std::all_of(tree.joints.begin(), tree.joints.end(), [&](const model::Joint& joint) {
    const std::optional<model::Rotor>& rotor = joint.drive.rotor;
    return !rotor || rotor->carrier == joint.parent || (rotor->carrier == 0 && !tree.floating_base);
  });
}

symbolic::Program forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const ForwardDynamicsChoice& choice) {
  Trace trace(tree);
  StateInputs in(trace, {State::position, State::velocity, State::force, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, choice.formulation);
  subtract_passive_forces(trace, in, in.tau);
  const bool by_matrix = choice.method == ForwardDynamicsMethod::inertia_matrix || !allows_articulated_bodies(tree);
  const ForwardMotion motion = by_matrix ? by_inertia_matrix(robot, in, load) : by_articulated_bodies(robot, in, load);
  trace.output("qdd", Role::joint_acceleration, motion.qdd);
  if (tree.floating_base) trace.output("base_acceleration", Role::base_acceleration, motion.base_acceleration);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
