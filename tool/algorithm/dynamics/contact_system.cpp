#include "algorithm/dynamics/contact_system.h"

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/spatial/describe.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Role;

OrderedInertia inertia_of(const TracedRobot& robot) {
  return {robot.tree(), joint_space_inertia(robot)};
}

LdlFactors factors_of(Trace& trace, const OrderedInertia& inertia) {
  trace.section("factor", "factors of the joint-space inertia matrix");
  return ldl_factors(inertia.a, inertia.names);
}

}  // namespace

ContactSystem::ContactSystem(const TracedRobot& robot, const ContactRows& rows)
    : trace_(robot.trace), inertia_(inertia_of(robot)), factors_(factors_of(trace_, inertia_)), W_(rows.size()) {
  for (int r = 0; r < rows.size(); ++r) {
    const std::string& name = rows.names[at(r)];
    trace_.section(name, "contacts: row " + name);
    Y_.push_back(first_half(factors_, inertia_.ordered(rows.J[at(r)])));
    std::vector<Expression>& per_d = per_d_.emplace_back();
    for (std::size_t k = 0; k < factors_.inverse_d.size(); ++k) {
      describe(Y_.back()[k], "Y_" + name + "_" + inertia_.names[k]);
      per_d.push_back(Y_.back()[k] * factors_.inverse_d[k]);
    }
    for (int c = 0; c <= r; ++c) {
      Expression sum;
      for (std::size_t k = 0; k < per_d.size(); ++k) sum += per_d[k] * Y_[at(c)][k];
      W_(r, c) = W_(c, r) = sum;
      describe(sum, "W_" + name + "_" + rows.names[at(c)]);
    }
  }
}

std::vector<Expression> ContactSystem::halved(const std::vector<Expression>& forces) const {
  return first_half(factors_, inertia_.ordered(forces));
}

std::vector<Expression> ContactSystem::at_contacts(const std::vector<Expression>& halved) const {
  std::vector<Expression> result;
  for (const std::vector<Expression>& row : per_d_) {
    Expression& sum = result.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) sum += row[k] * halved[k];
  }
  return result;
}

std::vector<Expression> ContactSystem::accelerations(
    std::vector<Expression> halved,
    const std::vector<Expression>& wrenches) const {
  trace_.section("solution", "accelerations");
  for (std::size_t r = 0; r < Y_.size(); ++r)
    for (std::size_t k = 0; k < halved.size(); ++k) halved[k] += Y_[r][k] * wrenches[r];
  return inertia_.unordered(second_half(factors_, halved));
}

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
  trace.section("contacts", "contacts: which are active");
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
  // Symmetric but for rounding: one half stands for both.
  for (int r = 0; r < n; ++r)
    for (int c = 0; c <= r; ++c) result(r, c) = result(c, r) = columns[at(c)][at(r)];
  return result;
}

}  // namespace robcogen::algorithm
