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
    right.push_back({"_" + rows_.names[at(r)], std::vector<Expression>(at(n))});
    right.back().b[at(r)] = switches_.active[at(rows_.contact[at(r)])];
  }
  const std::vector<std::vector<Expression>> columns = solve(matrix_, std::move(right), rows_.names);
  SquareMatrix result(n);
  // The matrix is symmetric up to rounding: one triangle is used for both.
  for (int r = 0; r < n; ++r)
    for (int c = 0; c <= r; ++c) result(r, c) = result(c, r) = columns[at(c)][at(r)];
  return result;
}

}  // namespace robcogen::algorithm
