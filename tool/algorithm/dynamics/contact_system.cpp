#include "algorithm/dynamics/contact_system.h"

namespace robcogen::algorithm {

using symbolic::Role;

ContactSwitches::ContactSwitches(Trace& trace, const ContactFrames& contacts) {
  std::vector<std::string> names;
  for (const model::ContactFrame& contact : contacts) names.push_back(contact.frame.name);
  active = trace.input("active", Role::contact_activity, names);
  compliance = trace.input("compliance", Role::contact_compliance, force_elements(contacts));
}

ActiveContacts::ActiveContacts(
    Trace& trace,
    const ContactRows& rows,
    const SquareMatrix& W,
    const ContactSwitches& switches)
    : trace_(trace), rows_(rows), switches_(switches), matrix_(W) {
  trace.section("contacts", "contacts: active rows");
  for (int r = 0; r < rows.size(); ++r) {
    const int own = rows.contact[at(r)];
    for (int c = 0; c < r; ++c) {
      const int other = rows.contact[at(c)];
      if (own == other || W(r, c).is_zero()) continue;
      const Expression both = switches.active[at(own)] * switches.active[at(other)];
      matrix_(r, c) = matrix_(c, r) = both * W(r, c);
    }
    const Expression off = trace.graph.one() - switches.active[at(own)];
    const Expression added = switches.compliance[at(r)] + off;
    matrix_(r, r) += added;
  }
}

std::vector<Expression> ActiveContacts::activity() const {
  std::vector<Expression> result;
  for (const int contact : rows_.contact) result.push_back(switches_.active[at(contact)]);
  return result;
}

std::vector<Expression> ActiveContacts::wrenches(std::vector<Expression> b) const {
  trace_.section("contacts", "contacts: wrenches");
  for (int r = 0; r < rows_.size(); ++r) b[at(r)] = switches_.active[at(rows_.contact[at(r)])] * b[at(r)];
  return solve(matrix_, std::move(b), rows_.names);
}

SquareMatrix ActiveContacts::inverse() const {
  trace_.section("contacts", "contacts: inertia");
  const int n = rows_.size();
  std::vector<RightSide> right;
  for (int r = 0; r < n; ++r) {
    right.push_back({rows_.names[at(r)], std::vector<Expression>(at(n))});
    right.back().b[at(r)] = switches_.active[at(rows_.contact[at(r)])];
  }
  const std::vector<std::vector<Expression>> columns = solve(matrix_, std::move(right), rows_.names);
  SquareMatrix result(n);
  // The matrix is symmetric up to rounding: one triangle is used for both.
  for (int r = 0; r < n; ++r)
    for (int c = 0; c <= r; ++c) result(r, c) = result(c, r) = columns[at(c)][at(r)];
  return result;
}

ConstrainedMotion constrained_motion(
    Trace& trace,
    const SwitchedContacts& contacts,
    const std::vector<Expression>& tau,
    const Forces& bias,
    const std::vector<Expression>& of_contacts,
    const std::vector<Expression>& wanted) {
  trace.section("contacts", "contacts: missing accelerations");
  const std::vector<Expression> halved = contacts.system.halved(missing_forces(trace, tau, bias));
  const std::vector<Expression> free = contacts.system.at_rows(halved);
  std::vector<Expression> missing;
  for (std::size_t r = 0; r < wanted.size(); ++r) missing.push_back(wanted[r] - of_contacts[r] - free[r]);
  std::vector<Expression> wrenches = contacts.active.wrenches(missing);
  return {contacts.system.accelerations(halved, wrenches), std::move(wrenches)};
}

ConstrainedImpact constrained_impact(
    Trace& trace,
    const SwitchedContacts& contacts,
    const std::vector<Expression>& before,
    const std::vector<Expression>& restitution) {
  const ContactRows& rows = contacts.rows;
  std::vector<Expression> change;
  for (const Expression& velocity : times(rows, before))
    change.push_back(-(trace.graph.one() + restitution[at(rows.contact[change.size()])]) * velocity);
  std::vector<Expression> impulses = contacts.active.wrenches(change);
  const std::vector<Expression> none(before.size());
  return {contacts.system.accelerations(none, impulses), std::move(impulses)};
}

std::vector<Expression> stacked_velocities(const StateInputs& in, const Trace& trace) {
  std::vector<Expression> v;
  if (trace.tree.floating_base)
    for (const Vector3& part : {in.base_velocity.angular, in.base_velocity.linear})
      v.insert(v.end(), part.element.begin(), part.element.end());
  for (const int joint : trace.tree.coordinates()) v.push_back(in.qd[at(joint)]);
  return v;
}

void output_motion(Trace& trace, const std::vector<Expression>& v, const NamedRole& joints, const NamedRole& base) {
  const int first = trace.tree.floating_base ? 6 : 0;
  trace.output(joints.name, joints.role, {v.begin() + first, v.end()});
  if (first > 0) trace.output(base.name, base.role, Motion{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}});
}

}  // namespace robcogen::algorithm
