#include "pass/statements.h"

#include <utility>

#include "support/index.h"

namespace robcogen::pass {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

Program rearrange(Program p, const std::vector<int>& kept, const std::vector<int>& replacement) {
  std::vector<int> place(p.statements.size(), -1);
  for (std::size_t k = 0; k < kept.size(); ++k) place[at(kept[k])] = static_cast<int>(k);
  const auto renumber = [&](Operand& o) {
    if (!is_statement(o)) return;
    o.index = place[at(replacement[at(o.index)])];
  };
  std::vector<Statement> statements;
  statements.reserve(kept.size());
  for (int i : kept) {
    Statement& s = statements.emplace_back(std::move(p.statements[at(i)]));
    for_each_operand(s, renumber);
  }
  p.statements = std::move(statements);
  for (symbolic::OutputArray& array : p.outputs)
    for (Operand& o : array.values) renumber(o);
  return p;
}

std::vector<int> use_counts(const Program& p) {
  std::vector<int> uses(p.statements.size(), 0);
  for (const Statement& s : p.statements) for_each_read(s, [&](int read) { ++uses[at(read)]; });
  for (const symbolic::OutputArray& array : p.outputs)
    for (const Operand& o : array.values)
      if (is_statement(o)) ++uses[at(o.index)];
  return uses;
}

std::vector<bool> inner_sums(const Program& p, const std::vector<int>& uses) {
  std::vector<bool> inner(p.statements.size(), false);
  for (const Statement& s : p.statements) {
    if (!is_sum(s.op)) continue;
    for_each_read(s, [&](int read) { inner[at(read)] = uses[at(read)] == 1 && is_sum(p.statements[at(read)].op); });
  }
  return inner;
}

void terms_of(const Program& p, const std::vector<bool>& inner, int sum, std::vector<Operand>& terms) {
  terms.clear();
  std::vector<Operand> pending = {{Operand::Kind::statement, sum, false}};
  for (bool root = true; !pending.empty(); root = false) {
    const Operand o = pending.back();
    pending.pop_back();
    if (!root && (!is_statement(o) || !inner[at(o.index)])) {
      terms.push_back(o);
      continue;
    }
    const Statement& s = p.statements[at(o.index)];
    Operand a = s.a, b = s.b;
    a.negative = a.negative != o.negative;
    b.negative = b.negative != (o.negative != (s.op == Op::subtract));
    pending.push_back(b);
    pending.push_back(a);
  }
}

}  // namespace robcogen::pass
