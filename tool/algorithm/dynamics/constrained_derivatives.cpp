// Derivatives of the dynamics with contacts, by implicit differentiation: at a solution (a, f), the residuals of the
// equations of motion and of the accelerations of the contacts stay zero. So the derivatives of (a, f) are the
// solutions of the same linear system for minus the derivatives of the residuals at fixed (a, f): those of inverse
// dynamics without contacts, of J^T f, and of the accelerations of the contact frames (Carpentier and Mansard 2018;
// Budhiraja, Carpentier, Mastalli and Mansard 2018).
#include <utility>

#include "algorithm/dynamics/constrained_factors.h"
#include "algorithm/dynamics/contact_motion.h"
#include "algorithm/dynamics/contacts.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/force_derivatives.h"
#include "algorithm/dynamics/looped_derivatives.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

enum class ContactSolutions { written_out, in_columns };

using Elements = std::vector<Expression>;

// Minus the derivatives of the residuals: by row of H, then by row of the contacts.
Elements right_side(const Elements& of_forces, const Elements& of_contacts) {
  Elements b;
  for (const Elements* part : {&of_forces, &of_contacts})
    for (const Expression& e : *part) b.push_back(-e);
  return b;
}

Columns right_sides(const Columns& of_forces, const Columns& of_contacts) {
  Columns b;
  for (std::size_t c = 0; c < of_forces.size(); ++c) b.push_back(right_side(of_forces[c], of_contacts[c]));
  return b;
}

// Right-hand sides that are one at a row, for `count` rows from `first` on.
Columns unit_columns(Trace& trace, std::size_t size, int first, int count) {
  Columns b(at(count), Elements(size));
  for (int k = 0; k < count; ++k) b[at(k)][at(first + k)] = trace.graph.one();
  return b;
}

Columns columns_of_inertia(const ForceDerivatives& d) {
  Columns columns = d.base_acceleration;
  columns.insert(columns.end(), d.qdd.begin(), d.qdd.end());
  return columns;
}

void subtract(Columns& a, const Columns& b) {
  for (std::size_t c = 0; c < a.size(); ++c)
    for (std::size_t r = 0; r < a[c].size(); ++r) a[c][r] -= b[c][r];
}

// A block of derivatives: right-hand sides, or with `solved` less columns than all, results behind these.
struct ColumnBlock {
  std::string name;
  Columns columns;
  std::size_t solved;
};

ColumnBlock block_of(std::string name, Columns columns) {
  const std::size_t count = columns.size();
  return {std::move(name), std::move(columns), count};
}

// Solves for the columns, unless a loop does, and outputs the blocks.
void output_blocks(
    Trace& trace,
    const ConstrainedStructure& structure,
    const ConstrainedFactors& factors,
    std::vector<ColumnBlock> blocks,
    ContactSolutions solutions) {
  trace.section("solution", "derivatives of the solution");
  int number = 0;
  for (ColumnBlock& block : blocks) {
    for (std::size_t c = 0; c < block.solved && solutions == ContactSolutions::written_out; ++c)
      block.columns[c] = solve(structure, factors, block.columns[c], std::to_string(number++));
    trace.output(block.name, Role::matrix, static_cast<int>(structure.rows.size()), block.columns);
  }
  if (solutions == ContactSolutions::in_columns) trace.output("factor", Role::value, numbers_of(structure, factors));
}

// The solution of one column for given factors.
Program solution_of_column(const ConstrainedStructure& structure, const std::string& name) {
  ProgramTrace trace;
  const ConstrainedFactors factors = factors_from(structure, trace.input("factor", Role::value, labels_of(structure)));
  const Elements b = trace.input("b", Role::value, structure.rows);
  trace.section("solution", "one column of the solution");
  trace.output("x", Role::value, solve(structure, factors, b));
  return trace.program(name);
}

// A robot at rest with the same positions.
StateInputs at_rest(const StateInputs& in) {
  StateInputs rest = in;
  rest.qd.assign(in.qd.size(), {});
  rest.qdd = rest.qd;
  rest.base_velocity = rest.base_acceleration = {};
  return rest;
}

// The rows of contacts. They are those of the contacts' motion, unless a chain of closures is differentiated as a
// whole.
ContactRows rows_for(Trace& trace, const StateInputs& in, const ContactFrames& contacts) {
  if (trace.tree.has_closures()) return {trace, in.q, contacts};
  return contact_rows(trace, contacts, contact_motions(trace, at_rest(in), contacts));
}

// ---- Forward dynamics.

// Derivatives of both residuals by the columns of q, qd and the angular velocity of the base, and d.qdd,
// d.base_acceleration and the free columns of the forces alone.
struct ResidualDerivatives {
  ForceDerivatives of_forces;
  Columns of_contacts_q, of_contacts_qd, of_contacts_base_w;
};

ResidualDerivatives residual_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const LoadInputs& load,
    const ContactFrames& contacts,
    const Elements& wrenches) {
  Trace& trace = robot.trace;
  const LinkMotion base = base_motion(in.base_velocity, in.base_acceleration, load.gravity);
  const Forces forces = newton_euler_forces(robot, base, in.qd, in.qdd, &load);
  ResidualDerivatives d{force_derivatives(robot, in, load.gravity, forces), {}, {}, {}};
  const std::vector<ContactMotion> motions = contact_motions(trace, in, contacts);
  subtract(d.of_forces.q, generalized_force_derivatives(trace, contacts, motions, wrenches));
  d.of_contacts_q = by_coordinate(trace, contacts, motions, &ContactColumn::acceleration_by_position);
  d.of_contacts_qd = by_coordinate(trace, contacts, motions, &ContactColumn::acceleration_by_velocity);
  for (std::size_t k = 0; robot.floating() && k < 3; ++k) {
    Elements& column = d.of_contacts_base_w.emplace_back();
    for (std::size_t c = 0; c < contacts.size(); ++c)
      for (const Expression& e : elements_of(contacts[c], motions[c].acceleration_by_base_velocity[k]))
        column.push_back(e);
  }
  return d;
}

// Divides columns over both residuals.
std::pair<Columns, Columns> split(const Columns& both, std::size_t first) {
  std::pair<Columns, Columns> parts;
  for (const Elements& column : both) {
    const auto middle = column.begin() + static_cast<std::ptrdiff_t>(first);
    parts.first.emplace_back(column.begin(), middle);
    parts.second.emplace_back(middle, column.end());
  }
  return parts;
}

std::vector<symbolic::Rate> held(Elements values, std::vector<symbolic::Rate> rates) {
  for (const Expression& e : values) rates.push_back({e, Expression()});
  return rates;
}

// The same for a robot with loops, by the chain rule over expressions.
ResidualDerivatives looped_residual_derivatives(
    const TracedRobot& robot,
    const StateInputs& in,
    const LoadInputs& load,
    const ContactFrames& contacts,
    const ContactRows& rows,
    const Elements& wrenches) {
  Trace& trace = robot.trace;
  const LinkMotion base = base_motion(in.base_velocity, in.base_acceleration, load.gravity);
  Forces forces = newton_euler_forces(robot, base, in.qd, in.qdd, &load);
  add_passive_forces(trace, in, forces.tau);
  ResidualDerivatives d{force_derivatives(robot, in, load.gravity, forces), {}, {}, {}};
  Elements of = transposed_times(rows, wrenches);
  const std::size_t size = of.size();
  for (const Expression& e : contact_bias(robot, forces.motions, load.gravity, contacts)) of.push_back(e);
  const std::vector<symbolic::Rate> constant = held(wrenches, held_accelerations(trace.tree, in));
  auto [of_forces, of_contacts] = split(derivatives_by_positions(trace, of, in.q, constant), size);
  subtract(d.of_forces.q, of_forces);
  d.of_contacts_q = std::move(of_contacts);
  const Elements accelerations(of.begin() + static_cast<std::ptrdiff_t>(size), of.end());
  d.of_contacts_qd = derivatives_by_velocities(trace, accelerations, in.qd, constant);
  for (std::size_t k = 0; robot.floating() && k < 3; ++k)
    d.of_contacts_base_w.push_back(derivative_by_velocity(trace, accelerations, in.base_velocity.angular[k], constant));
  return d;
}

Program forward_derivatives(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation,
    ContactSolutions solutions) {
  Trace trace(tree);
  StateInputs in(trace, {State::position, State::velocity, State::force, State::base_velocity});
  const Elements wanted = trace.input("contact_acceleration", Role::value, motion_elements(contacts));
  const ContactSwitches switches(trace, contacts);
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  subtract_passive_forces(trace, in, in.tau);
  const Forces bias = bias_forces(robot, in, load);
  const Elements of_contacts = contact_bias(robot, bias.motions, load.gravity, contacts);
  const SwitchedContacts switched(robot, rows_for(trace, in, contacts), switches);
  const auto [a, wrenches] = constrained_motion(trace, switched, in.tau, bias, of_contacts, wanted);
  const int base = tree.floating_base ? 6 : 0, n = tree.dof(), m = switched.rows.size();
  if (base > 0) in.base_acceleration = {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}};
  in.qdd = trace.by_joint("qdd", Role::joint_acceleration, held_apart(trace, {a.begin() + base, a.end()}));
  const ResidualDerivatives d = tree.has_closures()
                                    ? looped_residual_derivatives(robot, in, load, contacts, switched.rows, wrenches)
                                    : residual_derivatives(robot, in, load, contacts, wrenches);
  output_motion(trace, a, {"qdd", Role::joint_acceleration}, {"base_acceleration", Role::base_acceleration});
  trace.output("contact_wrenches", Role::value, wrenches);

  const ConstrainedStructure structure(tree, contacts);
  const std::size_t size = structure.rows.size();
  const Columns none(6, Elements(at(m)));  // gravity does not accelerate contacts that are held
  std::vector<ColumnBlock> blocks = {
      block_of("d_q", right_sides(d.of_forces.q, d.of_contacts_q)),
      block_of("d_qd", right_sides(d.of_forces.qd, d.of_contacts_qd)),
      block_of("d_tau", unit_columns(trace, size, base, n))};
  if (base > 0) {
    const Columns by_turning(d.of_forces.base_velocity.begin(), d.of_forces.base_velocity.begin() + 3);
    Columns by_velocity = right_sides(by_turning, d.of_contacts_base_w);
    // A linear velocity v of the base changes the motion of all links by w x v, and nothing else.
    ForceDerivatives free;
    free.base_rotation.resize(3, Elements(size));
    free.base_velocity.resize(6, Elements(size));
    fill_free_fall(trace, in.base_velocity.angular, load.gravity, free);
    by_velocity.insert(by_velocity.end(), free.base_velocity.begin() + 3, free.base_velocity.end());
    blocks.push_back(block_of("d_base_rotation", right_sides(d.of_forces.base_rotation, none)));
    blocks.push_back({"d_base_velocity", std::move(by_velocity), 3});
  }
  blocks.push_back(block_of("d_contact_acceleration", unit_columns(trace, size, base + n, m)));
  output_blocks(trace, structure, constrained_factors(switched), std::move(blocks), solutions);
  return trace.program(name);
}

// ---- Impacts.

// The derivatives by positions of H change - J^T impulses and of the velocities of the contacts after the impact plus
// `restitution` times those before, at fixed changes of velocities and impulses; and H.
struct ImpactDerivatives {
  ForceDerivatives of_momentum;
  Columns of_contacts;
};

// Sets the velocities of the base and of the joints, from values by row of H.
void set_velocities(Trace& trace, const Elements& v, StateInputs& in) {
  const std::ptrdiff_t base = trace.tree.floating_base ? 6 : 0;
  if (base > 0) in.base_velocity = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  in.qd = trace.by_joint("qd", Role::joint_velocity, {v.begin() + base, v.end()});
}

ImpactDerivatives residual_derivatives_of_impact(
    const TracedRobot& robot,
    const StateInputs& in,
    const ContactFrames& contacts,
    const ContactRows& rows,
    const ConstrainedImpact& impact,
    const std::vector<Expression>& restitution) {
  Trace& trace = robot.trace;
  const Elements before = stacked_velocities(in, trace);
  // The change of the velocities, as accelerations from rest, has the momentum as its forces.
  StateInputs changed = at_rest(in), change = changed;
  set_velocities(trace, impact.change, change);
  changed.qdd = change.qd;
  changed.base_acceleration = change.base_velocity;
  const LinkMotion base = base_motion({}, changed.base_acceleration, {});
  const Forces momentum = newton_euler_forces(robot, base, changed.qd, changed.qdd, nullptr);
  ImpactDerivatives d{force_derivatives(robot, changed, {}, momentum, PassiveForces::left_out), {}};
  std::vector<Elements> velocities;  // by contact
  for (const Expression& e : restitution) {
    Elements& v = velocities.emplace_back();
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Expression after = impact.change[k] + before[k];
      v.push_back(after + e * before[k]);
    }
  }
  if (trace.tree.has_closures()) {
    Elements of = transposed_times(rows, impact.impulses);
    const std::size_t size = of.size();
    std::vector<Elements> by_contact;
    for (const Elements& v : velocities) by_contact.push_back(times(rows, v));
    for (std::size_t r = 0; r < rows.contact.size(); ++r) of.push_back(by_contact[at(rows.contact[r])][r]);
    const auto constant = held(impact.impulses, held(impact.change, {}));
    auto [of_forces, of_contacts] = split(derivatives_by_positions(trace, of, in.q, constant), size);
    subtract(d.of_momentum.q, of_forces);
    d.of_contacts = std::move(of_contacts);
    return d;
  }
  std::vector<ContactMotion> motions;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    StateInputs moving = at_rest(in);
    set_velocities(trace, velocities[c], moving);
    motions.push_back(contact_motion(trace, moving, contacts[c].frame));
  }
  subtract(d.of_momentum.q, generalized_force_derivatives(trace, contacts, motions, impact.impulses));
  d.of_contacts = by_coordinate(trace, contacts, motions, &ContactColumn::velocity_by_position);
  return d;
}

Program derivatives_of_impact(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation,
    ContactSolutions solutions) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  std::vector<std::string> names;
  for (const model::ContactFrame& contact : contacts) names.push_back(contact.frame.name);
  const Elements restitution = trace.input("restitution", Role::value, names);
  const ContactSwitches switches(trace, contacts);
  const TracedRobot robot(trace, in.q, formulation);
  const SwitchedContacts switched(robot, rows_for(trace, in, contacts), switches);
  const ContactRows& rows = switched.rows;
  const Elements before = stacked_velocities(in, trace);
  const ConstrainedImpact impact = constrained_impact(trace, switched, before, restitution);
  Elements after = impact.change;
  for (std::size_t k = 0; k < after.size(); ++k) after[k] += before[k];
  output_motion(trace, after, {"qd_after", Role::joint_velocity}, {"base_velocity_after", Role::base_velocity});
  trace.output("contact_impulses", Role::value, impact.impulses);
  const ImpactDerivatives d = residual_derivatives_of_impact(robot, in, contacts, rows, impact, restitution);

  const ConstrainedStructure structure(tree, contacts);
  const auto m = at(rows.size());
  const std::size_t base = tree.floating_base ? 6 : 0;
  // By velocities before the impact: H v+ = H v- + J^T f and J v+ = -restitution J v-.
  Columns by_velocity = columns_of_inertia(d.of_momentum);
  for (std::size_t c = 0; c < by_velocity.size(); ++c)
    for (std::size_t r = 0; r < m; ++r) by_velocity[c].push_back(-(restitution[at(rows.contact[r])] * rows.J[r][c]));
  const auto middle = by_velocity.begin() + static_cast<std::ptrdiff_t>(base);
  const Elements at_contacts = times(rows, before);
  Columns by_restitution(contacts.size(), Elements(structure.rows.size()));
  for (std::size_t r = 0; r < m; ++r) by_restitution[at(rows.contact[r])][before.size() + r] = -at_contacts[r];
  std::vector<ColumnBlock> blocks = {
      block_of("d_q", right_sides(d.of_momentum.q, d.of_contacts)), block_of("d_qd", {middle, by_velocity.end()})};
  if (base > 0) blocks.push_back(block_of("d_base_velocity", {by_velocity.begin(), middle}));
  blocks.push_back(block_of("d_restitution", std::move(by_restitution)));
  output_blocks(trace, structure, constrained_factors(switched), std::move(blocks), solutions);
  return trace.program(name);
}

}  // namespace

Program constrained_forward_dynamics_derivatives(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  return forward_derivatives(tree, contacts, name, loads, formulation, ContactSolutions::written_out);
}

symbolic::SolvedColumns constrained_forward_dynamics_derivatives_in_columns(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  symbolic::SolvedColumns result{
      forward_derivatives(tree, contacts, name + "_right_sides", loads, formulation, ContactSolutions::in_columns),
      solution_of_column({tree, contacts}, "constrained_forward_dynamics_derivatives_column"),
      {}};
  result.add_blocks(
      {{"d_q"}, {"d_qd"}, {"d_tau"}, {"d_base_rotation"}, {"d_base_velocity", 3}, {"d_contact_acceleration"}});
  return result;
}

Program impact_derivatives(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation) {
  return derivatives_of_impact(tree, contacts, name, formulation, ContactSolutions::written_out);
}

symbolic::SolvedColumns impact_derivatives_in_columns(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation) {
  symbolic::SolvedColumns result{
      derivatives_of_impact(tree, contacts, name + "_right_sides", formulation, ContactSolutions::in_columns),
      solution_of_column({tree, contacts}, "impact_derivatives_column"),
      {}};
  result.add_blocks({{"d_q"}, {"d_qd"}, {"d_base_velocity"}, {"d_restitution"}});
  return result;
}

}  // namespace robcogen::algorithm
