// Inverse dynamics of a robot with an unactuated floating base (Featherstone 2008, sec. 9.4).
#include <algorithm>
#include <utility>

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/force_derivatives.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/dynamics/newton_euler.h"
#include "algorithm/spatial/couplings.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {

using symbolic::Role;

namespace {

// With a base that does not accelerate, the motion needs a wrench on the base that nothing supplies. So the whole robot
// accelerates like one rigid body under the missing wrench.
struct FreeRobot {
  Forces forces;                          // with a base that does not accelerate
  std::vector<MassProperties> composite;  // by link
  Motion acceleration;                    // of the base
};

FreeRobot free_robot(const TracedRobot& robot, const StateInputs& in, const LoadInputs& load) {
  const LinkMotion base = base_motion(in.base_velocity, {}, load.gravity);
  FreeRobot result{newton_euler_forces(robot, base, in.qd, in.qdd, &load), composite_bodies(robot), {}};
  robot.trace.section(robot.link_name(0), "base: acceleration");
  result.acceleration = named(
      {"base", "acceleration"}, free_acceleration(rigid_body_inertia(result.composite[0]), result.forces.base_wrench));
  return result;
}

}  // namespace

void trace_unactuated_base_inverse_dynamics(Trace& trace, Loads loads, const Formulation& formulation) {
  const StateInputs in(trace, {State::position, State::velocity, State::acceleration, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  const FreeRobot free = free_robot(robot, in, load);
  std::vector<Expression> tau = free.forces.tau;
  add_composite_forces(robot, free.composite, free.acceleration, tau);
  add_passive_forces(trace, in, tau);
  trace.output("tau", Role::joint_force, by_coordinate(trace, tau));
  trace.output("base_acceleration", Role::base_acceleration, free.acceleration);
}

symbolic::Program unactuated_base_inverse_dynamics(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  trace_unactuated_base_inverse_dynamics(trace, loads, formulation);
  return trace.program(name);
}

namespace {

const std::vector<std::string> kBaseNames = {"wx", "wy", "wz", "vx", "vy", "vz"};

// The derivatives at a given base acceleration, from which those with an unactuated base follow.
struct FixedBaseDerivatives {
  Motion base_acceleration;
  Forces forces;
  ForceDerivatives d;    // at a given base acceleration
  SquareMatrix inertia;  // of the whole robot: H_bb
};

FixedBaseDerivatives fixed_base_derivatives(const TracedRobot& robot, StateInputs in, const LoadInputs& load) {
  const FreeRobot free = free_robot(robot, in, load);
  in.base_acceleration = free.acceleration;
  const LinkMotion base = base_motion(in.base_velocity, in.base_acceleration, load.gravity);
  Forces forces = newton_euler_forces(robot, base, in.qd, in.qdd, &load);
  add_passive_forces(robot.trace, in, forces.tau);
  ForceDerivatives d = force_derivatives(robot, in, load.gravity, forces);
  robot.trace.section(robot.link_name(0), "base: derivatives of the acceleration");
  return {free.acceleration, std::move(forces), std::move(d), matrix(rigid_body_inertia(free.composite[0]))};
}

// Lets the base accelerate: with H_bb a + H_bj qdd + … = 0 and the derivatives of the base wrench at a given base
// acceleration, da = -H_bb^-1 d(base wrench), d tau = d tau (given a) + H_jb da.
void release_base(FixedBaseDerivatives& given) {
  ForceDerivatives& d = given.d;
  std::vector<RightSide> right;
  std::vector<std::vector<Expression>*> columns;
  const auto add = [&](const std::string& by, Columns& block, std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) {
      std::vector<Expression> missing;
      for (std::size_t k = 0; k < 6; ++k) missing.push_back(-block[j][k]);
      right.push_back({by + std::to_string(j), std::move(missing)});
      columns.push_back(&block[j]);
    }
  };
  add("dq", d.q, d.q.size());
  add("dqd", d.qd, d.qd.size());
  add("dqdd", d.qdd, d.qdd.size());
  add("dw", d.base_velocity, 3);
  const auto solutions = solve(given.inertia, std::move(right), kBaseNames);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::vector<Expression>& column = *columns[c];
    for (std::size_t k = 0; k < 6; ++k) {
      column[k] = solutions[c][k];
      for (std::size_t row = 6; row < column.size(); ++row) column[row] += d.base_acceleration[k][row] * column[k];
    }
  }
}

void write_outputs(Trace& trace, const StateInputs& in, const LoadInputs& load, FixedBaseDerivatives& given) {
  ForceDerivatives& d = given.d;
  // Only rows 3 to 5 differ from zero, for any robot: all its parts fall with the same acceleration.
  fill_free_fall(trace, in.base_velocity.angular, load.gravity, d);
  trace.output("tau", Role::joint_force, by_coordinate(trace, given.forces.tau));
  trace.output("base_acceleration", Role::base_acceleration, given.base_acceleration);
  const int n = trace.tree.dof(), rows = 6 + n;
  trace.output("d_q", Role::matrix, rows, d.q);
  trace.output("d_qd", Role::matrix, rows, d.qd);
  trace.output("d_qdd", Role::matrix, rows, d.qdd);
  trace.output("d_base_rotation", Role::matrix, rows, d.base_rotation);
  trace.output("d_base_velocity", Role::matrix, rows, d.base_velocity);
}

// The elements of L that the elimination in H_bb leaves. The last three rows, those of the mass, have none among each
// other.
std::vector<std::pair<int, int>> elements_of_base_factor() {
  std::vector<std::pair<int, int>> elements;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < std::min(row, 3); ++column) elements.emplace_back(row, column);
  return elements;
}

// The numbers that columns are solved with: the factor of H_bb, and H_jb by columns.
std::vector<Expression> base_factor(const FixedBaseDerivatives& given) {
  const LdlFactors factors = ldl_factors(given.inertia, kBaseNames);
  std::vector<Expression> factor;
  for (const auto& [row, column] : elements_of_base_factor()) factor.push_back(factors.l(row, column));
  factor.insert(factor.end(), factors.inverse_d.begin(), factors.inverse_d.end());
  for (std::size_t k = 0; k < 6; ++k)
    factor.insert(factor.end(), given.d.base_acceleration[k].begin() + 6, given.d.base_acceleration[k].end());
  return factor;
}

enum class BaseSolutions { written_out, in_columns };

symbolic::Program free_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation,
    BaseSolutions solutions) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::acceleration, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  FixedBaseDerivatives given = fixed_base_derivatives(robot, in, load);
  std::vector<Expression> factor;
  if (solutions == BaseSolutions::written_out)
    release_base(given);
  else
    factor = base_factor(given);
  write_outputs(trace, in, load, given);
  if (!factor.empty()) trace.output("factor", Role::value, factor);
  return trace.program(name);
}

// Turns a column of derivatives at a given base acceleration into one with an unactuated base.
symbolic::Program released_column(const model::KinematicTree& tree, const std::string& name) {
  const std::vector<std::pair<int, int>> elements = elements_of_base_factor();
  const std::vector<std::string> names = coordinate_names(tree);
  std::vector<std::string> labels;
  for (const auto& [row, column] : elements) labels.push_back(kBaseNames[at(row)] + "_" + kBaseNames[at(column)]);
  labels.insert(labels.end(), kBaseNames.begin(), kBaseNames.end());
  for (const std::string& base : kBaseNames)
    for (std::size_t row = 6; row < names.size(); ++row) labels.push_back(names[row] + "_" + base);
  ProgramTrace trace;
  const std::vector<Expression> given = trace.input("factor", Role::value, labels);
  const std::vector<Expression> b = trace.input("b", Role::value, names);
  LdlFactors factors{SquareMatrix(6), {}};
  auto next = given.begin();
  for (const auto& [row, column] : elements) factors.l(row, column) = *next++;
  factors.inverse_d.assign(next, next + 6);
  next += 6;
  trace.section("solution", "one column of the solution");
  std::vector<Expression> missing;
  for (std::size_t k = 0; k < 6; ++k) missing.push_back(-b[k]);
  std::vector<Expression> x = second_half(factors, first_half(factors, missing));
  x.insert(x.end(), b.begin() + 6, b.end());
  for (std::size_t k = 0; k < 6; ++k)
    for (std::size_t row = 6; row < x.size(); ++row) x[row] += *next++ * x[k];
  describe_elements("x", names, x);
  trace.output("x", Role::value, x);
  return trace.program(name);
}

}  // namespace

symbolic::Program unactuated_base_inverse_dynamics_derivatives(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  return free_derivatives(tree, name, loads, formulation, BaseSolutions::written_out);
}

symbolic::SolvedColumns unactuated_base_inverse_dynamics_derivatives_in_columns(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  symbolic::SolvedColumns result{
      free_derivatives(tree, name + "_right_sides", loads, formulation, BaseSolutions::in_columns),
      released_column(tree, "inverse_dynamics_derivatives_column"),
      {}};
  result.add_blocks({{"d_q"}, {"d_qd"}, {"d_qdd"}, {"d_base_velocity", 3}});
  return result;
}

}  // namespace robcogen::algorithm
