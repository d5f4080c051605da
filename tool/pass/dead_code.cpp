#include <numeric>
#include <utility>

#include "pass/statements.h"

namespace robcogen::pass {

using symbolic::Operand;
using symbolic::Program;

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
