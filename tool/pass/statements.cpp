#include "pass/statements.h"

#include <numeric>
#include <utility>

namespace robcogen::pass {

using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

Program rearrange(Program p, const std::vector<int>& kept, const std::vector<int>& replacement) {
  std::vector<int> place(p.statements.size(), -1);
  for (std::size_t k = 0; k < kept.size(); ++k) place[static_cast<std::size_t>(kept[k])] = static_cast<int>(k);
  const auto renumber = [&](Operand& o) {
    if (!is_statement(o)) return;
    o.index = place[static_cast<std::size_t>(replacement[static_cast<std::size_t>(o.index)])];
  };
  std::vector<Statement> statements;
  statements.reserve(kept.size());
  for (int i : kept) {
    Statement& s = statements.emplace_back(std::move(p.statements[static_cast<std::size_t>(i)]));
    for_each_operand(s, renumber);
  }
  p.statements = std::move(statements);
  for (symbolic::OutputArray& array : p.outputs)
    for (Operand& o : array.values) renumber(o);
  return p;
}

}  // namespace robcogen::pass
