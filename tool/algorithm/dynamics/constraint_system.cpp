#include "algorithm/dynamics/constraint_system.h"

#include "algorithm/dynamics/composite_rigid_body.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

OrderedInertia inertia_of(const TracedRobot& robot) {
  return {robot.tree(), joint_space_inertia(robot)};
}

LdlFactors factors_of(Trace& trace, const OrderedInertia& inertia) {
  trace.section("factor", "factors of the joint-space inertia matrix");
  return ldl_factors(inertia.a, inertia.names);
}

}  // namespace

ConstraintSystem::ConstraintSystem(const TracedRobot& robot, const ConstraintRows& rows)
    : trace_(robot.trace), inertia_(inertia_of(robot)), factors_(factors_of(trace_, inertia_)), W_(rows.size()) {
  for (int r = 0; r < rows.size(); ++r) {
    const std::string& name = rows.names[at(r)];
    trace_.section(name, rows.kind + ": row " + name);
    Y_.push_back(first_half(factors_, inertia_.ordered(rows.J[at(r)])));
    std::vector<Expression>& per_d = per_d_.emplace_back();
    for (std::size_t k = 0; k < factors_.inverse_d.size(); ++k) {
      described(coordinates("Y", name, inertia_.names[k]), Y_.back()[k]);
      per_d.push_back(Y_.back()[k] * factors_.inverse_d[k]);
    }
    for (int c = 0; c <= r; ++c) {
      Expression sum;
      for (std::size_t k = 0; k < per_d.size(); ++k) sum += per_d[k] * Y_[at(c)][k];
      W_(r, c) = W_(c, r) = described(coordinates("W", name, rows.names[at(c)]), sum);
    }
  }
}

std::vector<Expression> ConstraintSystem::halved(const std::vector<Expression>& forces) const {
  return first_half(factors_, inertia_.ordered(forces));
}

std::vector<Expression> ConstraintSystem::at_rows(const std::vector<Expression>& halved) const {
  std::vector<Expression> result;
  for (const std::vector<Expression>& row : per_d_) {
    Expression& sum = result.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) sum += row[k] * halved[k];
  }
  return result;
}

std::vector<Expression> ConstraintSystem::accelerations(
    std::vector<Expression> halved,
    const std::vector<Expression>& f) const {
  trace_.section("solution", "accelerations");
  for (std::size_t r = 0; r < Y_.size(); ++r)
    for (std::size_t k = 0; k < halved.size(); ++k) halved[k] += Y_[r][k] * f[r];
  return inertia_.unordered(second_half(factors_, halved));
}

std::vector<Expression> times(const ConstraintRows& rows, const std::vector<Expression>& v) {
  std::vector<Expression> result;
  for (const std::vector<Expression>& row : rows.J) {
    Expression& sum = result.emplace_back();
    for (std::size_t k = 0; k < v.size(); ++k) sum += row[k] * v[k];
  }
  return result;
}

std::vector<Expression> transposed_times(const ConstraintRows& rows, const std::vector<Expression>& f) {
  std::vector<Expression> result(rows.J.empty() ? 0 : rows.J.front().size());
  for (std::size_t r = 0; r < rows.J.size(); ++r)
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += rows.J[r][k] * f[r];
  return result;
}

}  // namespace robcogen::algorithm
