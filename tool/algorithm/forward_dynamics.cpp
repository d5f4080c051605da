// Forward dynamics by articulated bodies, or by solving with the joint-space inertia matrix, whichever takes less time.
#include "algorithm/articulated_bodies.h"
#include "algorithm/dynamics.h"
#include "algorithm/frame_search.h"
#include "algorithm/inverse_dynamics.h"
#include "algorithm/joint_space_inertia.h"
#include "support/index.h"
#include "symbolic/accuracy.h"
#include "symbolic/count.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// H qdd = tau - bias, eliminated from the leaves (Featherstone 2008, sec. 6.5, without square roots).
ForwardMotion by_inertia_matrix(const Setup& setup, const ForwardInputs& in, const LoadInputs& load) {
  const model::KinematicTree& tree = setup.tree();
  const Forces bias = bias_forces(setup, in.qd, in.base_velocity, load);
  const std::vector<Expression> h = joint_space_inertia(setup);
  const std::vector<int> order = elimination_order(tree);
  const int base = tree.floating_base ? 6 : 0, size = base + tree.dof();
  std::vector<Expression> missing;
  if (tree.floating_base) {
    for (const Expression& e : bias.base_wrench.angular.element) missing.push_back(-e);
    for (const Expression& e : bias.base_wrench.linear.element) missing.push_back(-e);
  }
  setup.trace.section("solution", "solution with the joint-space inertia matrix");
  for (std::size_t j = 0; j < in.tau.size(); ++j) missing.push_back(in.tau[j] - bias.tau[j]);
  std::vector<std::vector<Expression>> a(at(size), std::vector<Expression>(at(size)));
  std::vector<Expression> b(at(size));
  for (std::size_t r = 0; r < a.size(); ++r) {
    for (std::size_t c = 0; c < a.size(); ++c) a[r][c] = h[at(order[r] + order[c] * size)];
    b[r] = missing[at(order[r])];
  }
  const std::vector<Expression> solution = solve(std::move(a), std::move(b));
  std::vector<Expression> x(at(size));
  for (std::size_t r = 0; r < solution.size(); ++r) x[at(order[r])] = solution[r];
  ForwardMotion motion;
  if (tree.floating_base) motion.base_acceleration = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  motion.qdd.assign(x.begin() + base, x.end());
  return motion;
}

Program traced(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation,
    ForwardDynamicsMethod method) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  ForwardInputs in;
  in.qd = trace.joint_input("qd", Role::joint_velocity);
  in.tau = trace.joint_input("tau", Role::joint_force);
  if (tree.floating_base) in.base_velocity = trace.spatial_input("base_velocity", Role::base_velocity);
  const LoadInputs load(trace, loads);
  const Setup setup(trace, q, formulation);
  const ForwardMotion motion = method == ForwardDynamicsMethod::inertia_matrix ? by_inertia_matrix(setup, in, load)
                                                                               : by_articulated_bodies(setup, in, load);
  trace.output("qdd", Role::joint_acceleration, motion.qdd);
  if (tree.floating_base) trace.output("base_acceleration", Role::base_acceleration, motion.base_acceleration);
  return trace.program(name);
}

// Elimination alone takes half a product and sum for each pair of ancestors, articulated bodies some hundred
// instructions a joint: no need to trace what cannot win, and what is cubic in the depth of the tree.
bool is_elimination_cheap(const model::KinematicTree& tree) {
  constexpr long kInstructionsOfJoint = 100;
  std::vector<long> depth(tree.joints.size());
  long pairs = 0;
  for (const int j : tree.topological()) {
    const int parent = tree.parent_joint_of(j);
    depth[at(j)] = parent < 0 ? (tree.floating_base ? 6 : 0) : depth[at(parent)] + 1;
    pairs += depth[at(j)] * depth[at(j)];
  }
  return pairs / 2 < kInstructionsOfJoint * tree.dof();
}

}  // namespace

ForwardDynamicsChoice forward_dynamics_choice(const model::KinematicTree& tree, const Formulation& formulation) {
  const Loads loads = default_loads(tree);
  const auto cheapest = [&](ForwardDynamicsMethod method) {
    const auto trace = [&](const model::KinematicTree& part, const Formulation& choice) {
      return traced(part, "forward_dynamics", loads, choice, method);
    };
    ForwardDynamicsChoice choice{method, formulation};
    choice.formulation.frames = cheap_frames(tree, formulation, trace);
    return choice;
  };
  const auto time = [&](const ForwardDynamicsChoice& choice) {
    return symbolic::predicted_time(traced(tree, "forward_dynamics", loads, choice.formulation, choice.method));
  };
  ForwardDynamicsChoice bodies = cheapest(ForwardDynamicsMethod::articulated_bodies);
  if (!formulation.choose_forward_dynamics || !is_elimination_cheap(tree)) return bodies;
  ForwardDynamicsChoice matrix = cheapest(ForwardDynamicsMethod::inertia_matrix);
  if (time(matrix) >= time(bodies)) return bodies;
  Formulation plain = plain_formulation();
  plain.is_draft = true;
  const symbolic::AccurateResults results(
      traced(tree, "forward_dynamics", loads, plain, ForwardDynamicsMethod::articulated_bodies),
      parameter_values(tree));
  matrix.formulation.is_draft = true;
  const bool keeps_digits =
      results.are_kept_by(traced(tree, "forward_dynamics", loads, matrix.formulation, matrix.method));
  matrix.formulation.is_draft = false;
  return keeps_digits ? matrix : bodies;
}

Program forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const ForwardDynamicsChoice& choice) {
  return traced(tree, name, loads, choice.formulation, choice.method);
}

Program forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  return forward_dynamics(tree, name, loads, forward_dynamics_choice(tree, formulation));
}

}  // namespace robcogen::algorithm
