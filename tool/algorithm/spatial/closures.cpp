#include "algorithm/spatial/closures.h"

#include <algorithm>

#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

std::unique_ptr<TracedClosure> traced(Trace& trace, const model::Closure& closure, std::vector<Expression>& q) {
  const std::string& name = trace.tree.loops[at(closure.loop)].name;
  trace.section(name, "loop " + name + ": positions");
  auto result = closure.method == model::Closure::Method::planar ? traced_in_plane(trace, closure, q)
                                                                 : traced_distance(trace, closure, q);
  for (const int joint : closure.dependents)
    trace.graph.describe(q[at(joint)], "q_" + trace.tree.joints[at(joint)].name);
  return result;
}

// With the inverse of one or two columns by cofactors.
const std::vector<std::vector<RateShare>>& TracedClosure::rates() {
  if (!rates_.empty()) return rates_;
  const std::string& name = trace_.tree.loops[at(closure_.loop)].name;
  trace_.section(name, "loop " + name + ": rates");
  const std::vector<Column> all = columns();
  std::vector<const Column*> dependent;
  for (const int joint : closure_.dependents)
    dependent.push_back(&*std::find_if(all.begin(), all.end(), [&](const Column& c) { return c.joint == joint; }));
  const Expression one = trace_.graph.one();
  if (dependent.size() == 1) {
    inverse_ = {{one / dependent[0]->rows[0]}};
  } else {
    const std::vector<Expression>&a = dependent[0]->rows, &b = dependent[1]->rows;
    const Expression reciprocal = one / difference_of_products(a[0], b[1], a[1], b[0]);
    inverse_ = {{reciprocal * b[1], -(reciprocal * b[0])}, {-(reciprocal * a[1]), reciprocal * a[0]}};
  }
  rates_.resize(dependent.size());
  for (const Column& column : all) {
    if (std::find(closure_.dependents.begin(), closure_.dependents.end(), column.joint) != closure_.dependents.end())
      continue;
    const std::vector<Expression> moved = solved(column.rows);
    for (std::size_t d = 0; d < rates_.size(); ++d) {
      rates_[d].push_back({column.joint, -moved[d]});
      const std::string& follower = trace_.tree.joints[at(closure_.dependents[d])].name;
      trace_.graph.describe(rates_[d].back().factor, "d_" + follower + "_" + trace_.tree.joints[at(column.joint)].name);
    }
  }
  return rates_;
}

std::vector<Expression> TracedClosure::solved(const std::vector<Expression>& rows) const {
  std::vector<Expression> result;
  for (const std::vector<Expression>& row : inverse_) {
    Expression sum;
    for (std::size_t k = 0; k < rows.size(); ++k) sum += row[k] * rows[k];
    result.push_back(sum);
  }
  return result;
}

std::vector<Expression> TracedClosure::reaction(std::vector<Expression>& forces) {
  rates();
  const std::string& name = trace_.tree.loops[at(closure_.loop)].name;
  trace_.section(name, "loop " + name + ": reaction");
  std::vector<Expression> lambda(inverse_.front().size());
  for (std::size_t d = 0; d < inverse_.size(); ++d)
    for (std::size_t row = 0; row < lambda.size(); ++row)
      lambda[row] += inverse_[d][row] * forces[at(closure_.dependents[d])];
  for (const Column& column : columns())
    for (std::size_t row = 0; row < lambda.size(); ++row) forces[at(column.joint)] -= column.rows[row] * lambda[row];
  return force_of(lambda);
}

std::vector<Expression> TracedClosure::accelerations(const std::vector<Expression>& qd) {
  rates();
  const std::string& name = trace_.tree.loops[at(closure_.loop)].name;
  trace_.section(name, "loop " + name + ": accelerations");
  std::vector<Expression> result = solved(bias(qd));
  for (Expression& e : result) e = -e;
  return result;
}

}  // namespace robcogen::algorithm
