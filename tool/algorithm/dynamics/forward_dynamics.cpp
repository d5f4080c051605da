// Forward dynamics by articulated bodies, or by solving with the joint-space inertia matrix.
#include <algorithm>
#include <utility>

#include "algorithm/dynamics/articulated_body.h"
#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/elimination.h"
#include "algorithm/dynamics/force_derivatives.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/dynamics/limb_columns.h"
#include "algorithm/dynamics/looped_derivatives.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/dynamics/ordered_inertia.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Role;

struct SolvedMotion {
  ForwardMotion motion;
  OrderedInertia H;
};

// H qdd = tau - bias, eliminated from the leaves (Featherstone 2008, sec. 6.5, without square roots).
SolvedMotion by_inertia_matrix(const TracedRobot& robot, const StateInputs& in, const LoadInputs& load) {
  const model::KinematicTree& tree = robot.tree();
  const Forces bias = bias_forces(robot, in, load);
  const OrderedInertia H(tree, joint_space_inertia(robot));
  robot.trace.section("solution", "solution with the joint-space inertia matrix");
  const std::vector<Expression> missing = missing_forces(robot.trace, in.tau, bias);
  const std::vector<Expression> x = H.unordered(solve(H.a, H.ordered(missing), H.names));
  ForwardMotion motion;
  const int base = tree.floating_base ? 6 : 0;
  if (tree.floating_base) motion.base_acceleration = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  motion.qdd.assign(x.begin() + base, x.end());
  return {motion, H};
}

// Replaces columns of forces by columns of the accelerations that compensate them: x by -H^-1 x.
void solve_columns(const OrderedInertia& H, const std::vector<std::vector<Expression>*>& columns) {
  std::vector<RightSide> right;
  for (const std::vector<Expression>* column : columns) {
    std::vector<Expression> missing;
    for (const Expression& e : H.ordered(*column)) missing.push_back(-e);
    right.push_back({std::to_string(right.size()), std::move(missing)});
  }
  const auto solutions = solve(H.a, std::move(right), H.names);
  for (std::size_t c = 0; c < columns.size(); ++c) *columns[c] = H.unordered(solutions[c]);
}

}  // namespace

bool allows_articulated_bodies(const model::KinematicTree& tree) {
  if (!tree.couplings.empty()) return false;
  return std::all_of(tree.joints.begin(), tree.joints.end(), [&](const model::Joint& joint) {
    const std::optional<model::Rotor>& rotor = joint.drive.rotor;
    return !rotor || rotor->carrier == joint.parent || (rotor->carrier == 0 && !tree.floating_base);
  });
}

void trace_forward_dynamics(Trace& trace, Loads loads, const ForwardDynamicsChoice& choice) {
  const model::KinematicTree& tree = trace.tree;
  StateInputs in(trace, {State::position, State::velocity, State::force, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, choice.formulation);
  subtract_passive_forces(trace, in, in.tau);
  const bool by_matrix = choice.method == ForwardDynamicsMethod::inertia_matrix || !allows_articulated_bodies(tree);
  const ForwardMotion motion =
      by_matrix ? by_inertia_matrix(robot, in, load).motion : by_articulated_bodies(robot, in, load);
  trace.output("qdd", Role::joint_acceleration, motion.qdd);
  if (tree.floating_base) trace.output("base_acceleration", Role::base_acceleration, motion.base_acceleration);
}

symbolic::Program forward_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const ForwardDynamicsChoice& choice) {
  Trace trace(tree);
  trace_forward_dynamics(trace, loads, choice);
  return trace.program(name);
}

namespace {

enum class Solutions { written_out, in_columns };

// With H x = (base wrench, tau) - …: the derivatives of x are -H^-1 times those of inverse dynamics at x (Carpentier
// and Mansard 2018, eq. 6).
symbolic::Program derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation,
    Solutions solutions) {
  Trace trace(tree);
  StateInputs in(trace, {State::position, State::velocity, State::force, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  subtract_passive_forces(trace, in, in.tau);
  const auto [motion, H] = by_inertia_matrix(robot, in, load);
  in.base_acceleration = motion.base_acceleration;
  const LinkMotion base = base_motion(in.base_velocity, in.base_acceleration, load.gravity);
  in.qdd = trace.by_joint("qdd", Role::joint_acceleration, held_apart(trace, motion.qdd));
  Forces forces = newton_euler_forces(robot, base, in.qd, in.qdd, &load);
  if (tree.has_closures()) add_passive_forces(trace, in, forces.tau);
  ForceDerivatives d = force_derivatives(robot, in, load.gravity, forces);
  trace.section("solution", "derivatives of the solution");
  const int n = tree.dof(), rows = H.a.size(), first = rows - n;
  Columns by_tau(at(n), std::vector<Expression>(at(rows)));
  for (int j = 0; j < n; ++j) by_tau[at(j)][at(first + j)] = -trace.graph.one();
  std::vector<std::vector<Expression>*> columns;
  for (Columns* block : {&d.q, &d.qd, &by_tau})
    for (std::vector<Expression>& column : *block) columns.push_back(&column);
  if (tree.floating_base)
    for (std::size_t k = 0; k < 3; ++k) columns.push_back(&d.base_velocity[k]);
  if (solutions == Solutions::written_out) {
    solve_columns(H, columns);
  } else {
    for (std::vector<Expression>* column : columns)
      for (Expression& e : *column) e = -e;
  }
  trace.output("qdd", Role::joint_acceleration, motion.qdd);
  if (tree.floating_base) trace.output("base_acceleration", Role::base_acceleration, motion.base_acceleration);
  trace.output("d_q", Role::matrix, rows, d.q);
  trace.output("d_qd", Role::matrix, rows, d.qd);
  trace.output("d_tau", Role::matrix, rows, by_tau);
  if (tree.floating_base) {
    fill_free_fall(trace, in.base_velocity.angular, load.gravity, d);
    trace.output("d_base_rotation", Role::matrix, rows, d.base_rotation);
    trace.output("d_base_velocity", Role::matrix, rows, d.base_velocity);
  }
  if (solutions == Solutions::in_columns) {
    trace.output("factor", Role::value, numbers_of(elimination_tree(tree), ldl_factors(H.a, H.names)));
  }
  return trace.program(name);
}

// The solution x of H x = b for a given factor.
symbolic::Program solution_with_factor(const model::KinematicTree& tree, const std::string& name) {
  const std::vector<std::string> names = coordinate_names(tree);
  const OrderedInertia H(tree, SquareMatrix(static_cast<int>(names.size())));
  ProgramTrace trace;
  const LdlFactors factors = given_factors(trace, elimination_tree(tree), H.names);
  const std::vector<Expression> b = trace.input("b", Role::value, names);
  trace.section("solution", "one column of the solution");
  const std::vector<Expression> half = first_half(factors, H.ordered(b));
  describe_elements("b", H.names, half);
  const std::vector<Expression> x = H.unordered(second_half(factors, half));
  describe_elements("x", names, x);
  trace.output("x", Role::value, x);
  return trace.program(name);
}

}  // namespace

symbolic::Program forward_dynamics_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  return derivatives(tree, name, loads, formulation, Solutions::written_out);
}

symbolic::SolvedColumns forward_dynamics_derivatives_in_columns(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  symbolic::SolvedColumns result{
      derivatives(tree, name + "_right_sides", loads, formulation, Solutions::in_columns),
      solution_with_factor(tree, "forward_dynamics_derivatives_column"),
      {}};
  result.add_blocks({{"d_q"}, {"d_qd"}, {"d_tau"}, {"d_base_velocity", 3}});
  find_limbs(tree, "forward_dynamics_derivatives_of_limbs", result);
  return result;
}

}  // namespace robcogen::algorithm
