#include "algorithm/dynamics/loop_constraints.h"

namespace robcogen::algorithm {
namespace {

bool is_declared(const model::Coupling& coupling) {
  return coupling.is_linear() && coupling.loop < 0;
}

}  // namespace

LoopConstraints::LoopConstraints(Trace& trace, const model::KinematicTree& looped, const std::vector<Expression>& q)
    : rows{"loops", {}, {}}, trace_(trace), looped_(looped) {
  for (const std::vector<model::Closure>* closures : {&looped.parallelograms, &looped.closures})
    for (const model::Closure& closure : *closures) add_closure(closure, q);
  for (const model::Coupling& coupling : looped.couplings)
    if (is_declared(coupling)) add_coupling(coupling, q);
}

std::vector<Expression>& LoopConstraints::add_row(const std::string& name) {
  const int base = looped_.floating_base ? 6 : 0;
  rows.names.push_back(name);
  return rows.J.emplace_back(at(base) + looped_.joints.size());
}

void LoopConstraints::add_closure(const model::Closure& closure, const std::vector<Expression>& q) {
  const std::string& name = looped_.loops[at(closure.loop())].name;
  trace_.section(name, "loop " + name + ": closure error");
  Part& part = parts_.emplace_back(Part{closure, traced_open(trace_, closure, q)});
  const std::vector<Expression> open = part.traced->independent(part.traced->error());
  error.insert(error.end(), open.begin(), open.end());
  trace_.section(name, "loop " + name + ": rates");
  const int base = looped_.floating_base ? 6 : 0;
  const std::size_t first = rows.J.size();
  for (std::size_t row = 0; row < open.size(); ++row) add_row(name + "_" + std::to_string(row + 1));
  for (const TracedClosure::Column& column : part.traced->columns()) {
    const std::vector<Expression> rates = part.traced->independent(column.rows);
    for (std::size_t row = 0; row < rates.size(); ++row) rows.J[first + row][at(base + column.joint)] += rates[row];
  }
}

void LoopConstraints::add_coupling(const model::Coupling& coupling, const std::vector<Expression>& q) {
  const std::string& name = looped_.joints[at(coupling.joint)].name;
  trace_.section(name, "joint " + name + ": coupling error");
  const int base = looped_.floating_base ? 6 : 0;
  std::vector<Expression>& row = add_row(name);
  row[at(base + coupling.joint)] = trace_.graph.one();
  Expression open = q[at(coupling.joint)] - trace_.lift(coupling.offset);
  for (const model::Coupling::Term& term : coupling.terms) {
    const Expression factor = trace_.lift(term.factor);
    row[at(base + term.joint)] -= factor;
    open -= factor * q[at(term.joint)];
  }
  error.push_back(open);
}

std::vector<Expression> LoopConstraints::bias(const std::vector<Expression>& qd) {
  std::vector<Expression> result;
  for (const Part& part : parts_) {
    const std::string& name = looped_.loops[at(part.closure.loop())].name;
    trace_.section(name, "loop " + name + ": accelerations");
    const std::vector<Expression> added = part.traced->independent(part.traced->bias(qd));
    result.insert(result.end(), added.begin(), added.end());
  }
  result.resize(at(rows.size()));
  return result;
}

LoopConstraints::Forces LoopConstraints::forces(const std::vector<Expression>& lambda) {
  Forces result{std::vector<std::vector<Expression>>(looped_.loops.size()), {}};
  auto next = lambda.begin();
  for (const Part& part : parts_) {
    const auto end = next + static_cast<std::ptrdiff_t>(part.closure.dependents.size());
    const auto of_closure = part.traced->force_of(part.traced->from_independent({next, end}));
    for (std::size_t k = 0; k < of_closure.size(); ++k) result.of_loops[at(part.closure.loops[k])] = of_closure[k];
    next = end;
  }
  result.of_couplings.assign(next, lambda.end());
  return result;
}

}  // namespace robcogen::algorithm
