#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "pass/passes.h"
#include "pass/statements.h"

namespace robcogen::pass {

using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

namespace {

// What a statement does to which operands; these as numbers.
struct Computation {
  Op op = Op::add;
  std::uint64_t a = 0, b = 0;
  friend bool operator==(const Computation&, const Computation&) = default;
};

struct HashOfComputation {
  std::size_t operator()(const Computation& c) const {
    std::uint64_t h = (c.a * 0x9e3779b97f4a7c15ULL + c.b) * 0xbf58476d1ce4e5b9ULL + static_cast<std::uint64_t>(c.op);
    h ^= h >> 29;
    return static_cast<std::size_t>(h * 0x94d049bb133111ebULL);
  }
};

std::uint64_t number_of(const Operand& o) {
  return static_cast<std::uint64_t>(o.index) * 8 + static_cast<std::uint64_t>(o.kind) * 2 + (o.negative ? 1 : 0);
}

}  // namespace

Program eliminate_common_subexpressions(Program p) {
  std::unordered_map<Computation, int, HashOfComputation> first;
  std::vector<int> replacement(p.statements.size()), kept;
  const auto resolve = [&](Operand o) {
    if (is_statement(o)) o.index = replacement[static_cast<std::size_t>(o.index)];
    return number_of(o);
  };
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    std::uint64_t a = resolve(s.a), b = symbolic::is_binary(s.op) ? resolve(s.b) : 0;
    if ((s.op == Op::add || s.op == Op::multiply) && b < a) std::swap(a, b);
    const auto [place, fresh] = first.emplace(Computation{s.op, a, b}, static_cast<int>(i));
    replacement[i] = place->second;
    if (fresh) kept.push_back(static_cast<int>(i));
  }
  return rearrange(std::move(p), kept, replacement);
}

Program eliminate_dead_code(Program p) {
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
  return rearrange(std::move(p), kept, same);
}

}  // namespace robcogen::pass
