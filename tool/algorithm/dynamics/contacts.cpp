#include "algorithm/dynamics/contacts.h"

#include <string>
#include <utility>

#include "algorithm/dynamics/contact_system.h"
#include "algorithm/dynamics/drives.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/spatial/couplings.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// Outputs a matrix that is given by rows.
void output_matrix(Trace& trace, const std::string& name, const std::vector<std::vector<Expression>>& rows) {
  std::vector<Expression> columns;
  const std::size_t count = rows.empty() ? 0 : rows.front().size();
  for (std::size_t c = 0; c < count; ++c)
    for (const std::vector<Expression>& row : rows) columns.push_back(row[c]);
  trace.output(name, Role::matrix, static_cast<int>(rows.size()), static_cast<int>(count), columns);
}

void subtract(Trace& trace, const std::vector<Expression>& generalized, std::vector<Expression>& tau, Force& base) {
  const std::size_t first = trace.tree.floating_base ? 6 : 0;
  for (std::size_t k = 0; k < first; ++k) (k < 3 ? base.moment[k] : base.linear[k - 3]) -= generalized[k];
  for (std::size_t k = 0; k < tau.size(); ++k) tau[k] -= generalized[first + k];
}

}  // namespace

Program contact_jacobian(const model::KinematicTree& tree, const ContactFrames& contacts, const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  output_matrix(trace, "J", ContactRows(trace, in.q, contacts).J);
  return trace.program(name);
}

Program contact_velocity(const model::KinematicTree& tree, const ContactFrames& contacts, const std::string& name) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const ContactRows rows(trace, in.q, contacts);
  trace.output("velocity", Role::value, times(rows, stacked_velocities(in, trace)));
  return trace.program(name);
}

Program contact_bias(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const TracedRobot robot(trace, in.q, formulation);
  trace.output("bias", Role::value, contact_bias(robot, forces_of_velocities(robot, in).motions, {}, contacts));
  return trace.program(name);
}

Program inverse_contact_inertia(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  const TracedRobot robot(trace, in.q, formulation);
  const ConstraintSystem system(robot, ContactRows(trace, in.q, contacts));
  const SquareMatrix& W = system.inverse_inertia();
  trace.output("W", Role::matrix, W.size(), W.size(), W.columns());
  return trace.program(name);
}

Program constrained_forward_dynamics(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  StateInputs in(trace, {State::position, State::velocity, State::force, State::base_velocity});
  const std::vector<Expression> wanted = trace.input("contact_acceleration", Role::value, motion_elements(contacts));
  const ContactSwitches switches(trace, contacts);
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, formulation);
  subtract_passive_forces(trace, in, in.tau);
  const Forces bias = bias_forces(robot, in, load);
  const std::vector<Expression> of_contacts = contact_bias(robot, bias.motions, load.gravity, contacts);
  const SwitchedContacts switched(robot, in.q, contacts, switches);
  const auto [accelerations, wrenches] = constrained_motion(trace, switched, in.tau, bias, of_contacts, wanted);
  output_motion(
      trace, accelerations, {"qdd", Role::joint_acceleration}, {"base_acceleration", Role::base_acceleration});
  trace.output("contact_wrenches", Role::value, wrenches);
  return trace.program(name);
}

Program impact(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  std::vector<std::string> names;
  for (const model::ContactFrame& contact : contacts) names.push_back(contact.frame.name);
  const std::vector<Expression> restitution = trace.input("restitution", Role::value, names);
  const ContactSwitches switches(trace, contacts);
  const TracedRobot robot(trace, in.q, formulation);
  const SwitchedContacts switched(robot, in.q, contacts, switches);
  const std::vector<Expression> before = stacked_velocities(in, trace);
  const auto [change, impulses] = constrained_impact(trace, switched, before, restitution);
  std::vector<Expression> after = change;
  for (std::size_t k = 0; k < after.size(); ++k) after[k] += before[k];
  output_motion(trace, after, {"qd_after", Role::joint_velocity}, {"base_velocity_after", Role::base_velocity});
  trace.output("contact_impulses", Role::value, impulses);
  return trace.program(name);
}

Program inverse_dynamics_with_contacts(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in = motion_inputs(trace);
  const std::vector<Expression> wrenches = trace.input("contact_wrenches", Role::value, force_elements(contacts));
  Forces forces = TracedMotion(trace, in, loads, formulation).forces;
  std::vector<Expression> tau = by_coordinate(trace, forces.tau);
  const ContactRows rows(trace, in.q, contacts);
  trace.section("contacts", "contacts: joint forces minus those of the wrenches");
  subtract(trace, transposed_times(rows, wrenches), tau, forces.base_wrench);
  trace.output("tau", Role::joint_force, tau);
  if (tree.floating_base) trace.output("base_wrench", Role::base_wrench, forces.base_wrench);
  return trace.program(name);
}

// With J = [J_b J_q] and weights G: f = G J_b y, (J_b^T G J_b + r) y = the wrench that the base needs.
Program constrained_inverse_dynamics(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  constexpr int kBase = 6;
  Trace trace(tree);
  const StateInputs in = motion_inputs(trace);
  const std::vector<Expression> weights = trace.input("weights", Role::contact_compliance, force_elements(contacts));
  const Expression regularization = trace.input("regularization", Role::contact_compliance, {"r"}).front();
  Forces forces = TracedMotion(trace, in, loads, formulation).forces;
  std::vector<Expression> tau = by_coordinate(trace, forces.tau);
  const ContactRows rows(trace, in.q, contacts);
  trace.section("contacts", "contacts: wrenches");
  std::vector<std::vector<Expression>> weighted;  // G J_b, by row
  SquareMatrix gram(kBase);
  for (int r = 0; r < rows.size(); ++r) {
    std::vector<Expression>& row = weighted.emplace_back();
    for (int k = 0; k < kBase; ++k) row.push_back(weights[at(r)] * rows.J[at(r)][at(k)]);
    for (int i = 0; i < kBase; ++i)
      for (int k = 0; k <= i; ++k) gram(i, k) += rows.J[at(r)][at(i)] * row[at(k)];
  }
  for (int i = 0; i < kBase; ++i) {
    gram(i, i) += regularization;
    for (int k = 0; k < i; ++k) gram(k, i) = gram(i, k);
  }
  const Force& needed = forces.base_wrench;
  std::vector<Expression> b(needed.moment.element.begin(), needed.moment.element.end());
  b.insert(b.end(), needed.linear.element.begin(), needed.linear.element.end());
  const std::vector<Expression> y = solve(gram, b, {"nx", "ny", "nz", "fx", "fy", "fz"});
  std::vector<Expression> wrenches;
  for (const std::vector<Expression>& row : weighted) {
    Expression& f = wrenches.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) f += row[k] * y[k];
  }
  subtract(trace, transposed_times(rows, wrenches), tau, forces.base_wrench);
  trace.output("tau", Role::joint_force, tau);
  trace.output("contact_wrenches", Role::value, wrenches);
  trace.output("base_wrench", Role::base_wrench, forces.base_wrench);
  return trace.program(name);
}

// With E = D J = [E_b E_q], D^2 the weights and U the torque weights, f = D g minimises (tau - E_q^T g)^T U (tau -
// E_q^T g)
// + g^T g if (1 + E_q U E_q^T) g = E_q U tau + E_b y, where y are the multipliers of the base: E_b^T g + r y = the
// wrench that the base needs. Weights may be zero.
Program minimum_torque_inverse_dynamics(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    Loads loads,
    const Formulation& formulation) {
  constexpr int kBase = 6;
  Trace trace(tree);
  const StateInputs in = motion_inputs(trace);
  const std::vector<std::string> elements = force_elements(contacts);
  const std::vector<Expression> weights = trace.input("weights", Role::contact_compliance, elements);
  std::vector<std::string> coordinates;
  for (const int joint : tree.coordinates()) coordinates.push_back(tree.joints[at(joint)].name);
  const std::vector<Expression> torque_weights = trace.input("torque_weights", Role::contact_compliance, coordinates);
  const Expression regularization = trace.input("regularization", Role::contact_compliance, {"r"}).front();
  Forces forces = TracedMotion(trace, in, loads, formulation).forces;
  std::vector<Expression> tau = by_coordinate(trace, forces.tau);
  const ContactRows rows(trace, in.q, contacts);

  trace.section("contacts", "contacts: wrenches");
  std::vector<Expression> roots;
  std::vector<std::vector<Expression>> scaled;  // E, by row
  for (int r = 0; r < rows.size(); ++r) {
    const Expression square = weights[at(r)] * weights[at(r)];
    roots.push_back(sqrt(sqrt(square)));  // a magnitude: finite whatever the sign
    std::vector<Expression>& row = scaled.emplace_back();
    for (const Expression& element : rows.J[at(r)]) row.push_back(roots.back() * element);
  }
  SquareMatrix system(rows.size());
  std::vector<RightSide> right(1 + kBase);
  right.front().name = "torque";
  for (int k = 0; k < kBase; ++k) right[at(1 + k)].name = "base" + std::to_string(k);
  for (int r = 0; r < rows.size(); ++r) {
    const std::vector<Expression>& row = scaled[at(r)];
    std::vector<Expression> costly;  // E_q U
    for (std::size_t j = 0; j < tau.size(); ++j) costly.push_back(row[at(kBase) + j] * torque_weights[j]);
    for (int i = 0; i <= r; ++i) {
      for (std::size_t j = 0; j < tau.size(); ++j) system(r, i) += costly[j] * scaled[at(i)][at(kBase) + j];
      system(i, r) = system(r, i);
    }
    system(r, r) += trace.graph.one();
    Expression& along = right.front().b.emplace_back();
    for (std::size_t j = 0; j < tau.size(); ++j) along += costly[j] * tau[j];
    for (int k = 0; k < kBase; ++k) right[at(1 + k)].b.push_back(row[at(k)]);
  }
  const std::vector<std::vector<Expression>> solved = solve(system, right, elements);

  SquareMatrix gram(kBase);
  const Force& needed = forces.base_wrench;
  std::vector<Expression> b(needed.moment.element.begin(), needed.moment.element.end());
  b.insert(b.end(), needed.linear.element.begin(), needed.linear.element.end());
  for (int i = 0; i < kBase; ++i) {
    for (int k = 0; k <= i; ++k) {
      for (int r = 0; r < rows.size(); ++r) gram(i, k) += scaled[at(r)][at(i)] * solved[at(1 + k)][at(r)];
      gram(k, i) = gram(i, k);
    }
    gram(i, i) += regularization;
    for (int r = 0; r < rows.size(); ++r) b[at(i)] -= scaled[at(r)][at(i)] * solved.front()[at(r)];
  }
  const std::vector<Expression> y = solve(gram, b, {"nx", "ny", "nz", "fx", "fy", "fz"});
  std::vector<Expression> wrenches;
  for (int r = 0; r < rows.size(); ++r) {
    Expression g = solved.front()[at(r)];
    for (int k = 0; k < kBase; ++k) g += solved[at(1 + k)][at(r)] * y[at(k)];
    wrenches.push_back(roots[at(r)] * g);
  }
  subtract(trace, transposed_times(rows, wrenches), tau, forces.base_wrench);
  trace.output("tau", Role::joint_force, tau);
  trace.output("contact_wrenches", Role::value, wrenches);
  trace.output("base_wrench", Role::base_wrench, forces.base_wrench);
  return trace.program(name);
}

Program operational_space(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::string& name,
    const Formulation& formulation) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position});
  const ContactSwitches switches(trace, contacts);
  const TracedRobot robot(trace, in.q, formulation);
  const SwitchedContacts switched(robot, in.q, contacts, switches);
  const auto& [rows, system, active] = switched;
  const SquareMatrix inertia = active.inverse();
  const std::size_t size = rows.J.front().size();
  const std::vector<Expression> none(size);
  // Columns of H^-1 J^T.
  std::vector<std::vector<Expression>> moved;
  for (int r = 0; r < rows.size(); ++r) {
    std::vector<Expression> unit(at(rows.size()));
    unit[at(r)] = trace.graph.one();
    moved.push_back(system.accelerations(none, unit));
  }
  trace.section("task", "dynamically consistent inverse and projector");
  std::vector<std::vector<Expression>> inverse(size, std::vector<Expression>(at(rows.size())));
  std::vector<std::vector<Expression>> projector(size, std::vector<Expression>(size));
  for (std::size_t i = 0; i < size; ++i) {
    for (int c = 0; c < rows.size(); ++c)
      for (int r = 0; r < rows.size(); ++r) inverse[i][at(c)] += moved[at(r)][i] * inertia(r, c);
    for (std::size_t k = 0; k < size; ++k) {
      if (i == k) projector[i][k] = trace.graph.one();
      for (int r = 0; r < rows.size(); ++r) projector[i][k] -= inverse[i][at(r)] * rows.J[at(r)][k];
    }
  }
  trace.output("inertia", Role::matrix, inertia.size(), inertia.size(), inertia.columns());
  output_matrix(trace, "inverse", inverse);
  output_matrix(trace, "projector", projector);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
