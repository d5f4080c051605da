#include <map>
#include <numeric>
#include <tuple>

#include "pass/passes.h"
#include "pass/statements.h"

namespace robcogen::pass {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

Program eliminate_common_subexpressions(const Program& p) {
  using Key = std::tuple<Op, int, int, bool, int, int, bool>;
  std::map<Key, int> first;
  std::vector<int> replacement(p.statements.size()), kept;
  const auto resolve = [&](Operand o) {
    if (is_statement(o)) o.index = replacement[static_cast<std::size_t>(o.index)];
    return std::tuple(static_cast<int>(o.kind), o.index, o.negative);
  };
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    auto a = resolve(s.a), b = symbolic::is_binary(s.op) ? resolve(s.b) : std::tuple(-1, -1, false);
    if ((s.op == Op::add || s.op == Op::multiply) && b < a) std::swap(a, b);
    const auto [place, fresh] = first.emplace(std::tuple_cat(std::tuple(s.op), a, b), static_cast<int>(i));
    replacement[i] = place->second;
    if (fresh) kept.push_back(static_cast<int>(i));
  }
  return rearrange(p, kept, replacement);
}

Program eliminate_dead_code(const Program& p) {
  std::vector<bool> needed(p.statements.size(), false);
  for (const symbolic::OutputArray& array : p.outputs)
    for (const Operand& o : array.values)
      if (is_statement(o)) needed[static_cast<std::size_t>(o.index)] = true;
  for (std::size_t i = p.statements.size(); i-- > 0;)
    if (needed[i]) for_each_read(p.statements[i], [&](int read) { needed[static_cast<std::size_t>(read)] = true; });
  std::vector<int> kept, same(p.statements.size());
  std::iota(same.begin(), same.end(), 0);
  for (int i : same)
    if (needed[static_cast<std::size_t>(i)]) kept.push_back(i);
  return rearrange(p, kept, same);
}

}  // namespace robcogen::pass
