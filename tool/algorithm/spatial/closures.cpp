#include "algorithm/spatial/closures.h"

#include <algorithm>

#include "algorithm/spatial/named.h"
#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

std::unique_ptr<TracedClosure> traced(Trace& trace, const model::Closure& closure, std::vector<Expression>& q) {
  const std::string& name = trace.tree.loops[at(closure.loop())].name;
  trace.section(name, "loop ", ": positions");
  using Method = model::Closure::Method;
  if (closure.method == Method::iterative) return traced_in_space(trace, closure, q, Positions::solved);
  auto result = closure.method == Method::planar ? traced_in_plane(trace, closure, q, Positions::solved)
                                                 : traced_distance(trace, closure, q, Positions::solved);
  for (const int joint : closure.dependents)
    described(coordinate("q", trace.tree.joints[at(joint)].name), q[at(joint)]);
  return result;
}

std::unique_ptr<TracedClosure> traced_open(Trace& trace, const model::Closure& closure, std::vector<Expression> q) {
  switch (closure.method) {
    case model::Closure::Method::planar:
      return traced_in_plane(trace, closure, q, Positions::given);
    case model::Closure::Method::distance:
      return traced_distance(trace, closure, q, Positions::given);
    case model::Closure::Method::iterative:
      break;
  }
  return traced_in_space(trace, closure, q, Positions::given);
}

bool TracedClosure::has_redundant_rows() {
  return error().size() > closure_.dependents.size();
}

bool TracedClosure::is_dependent(int joint) const {
  return std::find(closure_.dependents.begin(), closure_.dependents.end(), joint) != closure_.dependents.end();
}

void TracedClosure::section(const std::string& what) {
  const std::string& name = trace_.tree.loops[at(closure_.loop())].name;
  trace_.section(name, "loop " + name + ": " + what);
}

const DependentColumns& TracedClosure::dependent_columns() {
  if (dependent_columns_) return *dependent_columns_;
  section("rates");
  all_ = columns();
  std::vector<std::vector<Expression>> dependent;
  for (const int joint : closure_.dependents)
    dependent.push_back(
        std::find_if(all_.begin(), all_.end(), [&](const Column& c) { return c.joint == joint; })->rows);
  return dependent_columns_.emplace(trace_.graph, dependent);
}

const std::vector<std::vector<RateTerm>>& TracedClosure::rates() {
  if (!rates_.empty()) return rates_;
  const DependentColumns& dependent = dependent_columns();
  rates_.resize(closure_.dependents.size());
  for (const Column& column : all_) {
    if (is_dependent(column.joint)) continue;
    const std::vector<Expression> moved = dependent.solve(column.rows);
    for (std::size_t d = 0; d < rates_.size(); ++d) {
      rates_[d].push_back({column.joint, -moved[d]});
      const std::string& name = trace_.tree.joints[at(closure_.dependents[d])].name;
      described(coordinates("d", name, trace_.tree.joints[at(column.joint)].name), rates_[d].back().factor);
    }
  }
  return rates_;
}

std::vector<std::vector<Expression>> TracedClosure::reaction(std::vector<Expression>& forces) {
  const DependentColumns& dependent = dependent_columns();
  section("reaction");
  std::vector<Expression> of_dependents;
  for (const int joint : closure_.dependents) of_dependents.push_back(forces[at(joint)]);
  const std::vector<Expression> lambda = dependent.transposed_solve(of_dependents);
  for (const Column& column : all_)
    for (std::size_t row = 0; row < lambda.size(); ++row) forces[at(column.joint)] -= column.rows[row] * lambda[row];
  return force_of(lambda);
}

std::vector<Expression> TracedClosure::independent(const std::vector<Expression>& rows) {
  return has_redundant_rows() ? dependent_columns().in_basis(rows) : rows;
}

std::vector<Expression> TracedClosure::from_independent(const std::vector<Expression>& lambda) {
  return has_redundant_rows() ? dependent_columns().from_basis(lambda) : lambda;
}

std::vector<Expression> TracedClosure::accelerations(const std::vector<Expression>& qd) {
  rates();
  section("accelerations");
  std::vector<Expression> result = dependent_columns().solve(bias(qd));
  for (Expression& e : result) e = -e;
  return result;
}

std::vector<Expression> TracedClosure::changes(
    const std::vector<symbolic::Rate>& motion,
    const std::vector<Expression>& v) {
  rates();
  section("derivatives of rates");
  std::vector<Expression> total(all_.front().rows.size());
  for (const Column& column : all_) {
    const Expression& moved = v[at(column.joint)];
    if (moved.is_zero()) continue;
    const std::vector<Expression> change = symbolic::rates_of(column.rows, motion);
    for (std::size_t row = 0; row < total.size(); ++row) total[row] += change[row] * moved;
  }
  std::vector<Expression> result = dependent_columns().solve(total);
  for (Expression& e : result) e = -e;
  return result;
}

}  // namespace robcogen::algorithm
