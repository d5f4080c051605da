#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "pass/passes.h"
#include "pass/statements.h"

namespace robcogen::pass {

using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

// A run is an unbroken sequence of statements of one section. A statement that only a later run reads is computed
// there, next to its use; named ones stay where the algorithm put them, so that a section keeps what its title says.
Program sink(Program p) {
  const std::size_t n = p.statements.size();
  std::vector<int> own(n), section_of;  // run of a statement, section of a run
  for (std::size_t i = 0; i < n; ++i) {
    if (i == 0 || p.statements[i].section != p.statements[i - 1].section) section_of.push_back(p.statements[i].section);
    own[i] = static_cast<int>(section_of.size()) - 1;
  }

  constexpr int kNever = std::numeric_limits<int>::max();
  std::vector<int> first_use(n, kNever), target(n);
  std::vector<bool> output(n, false);
  for (const symbolic::OutputArray& array : p.outputs)
    for (const Operand& o : array.values)
      if (is_statement(o)) output[static_cast<std::size_t>(o.index)] = true;
  for (std::size_t i = n; i-- > 0;) {
    const Statement& s = p.statements[i];
    target[i] = s.named || output[i] || first_use[i] == kNever ? own[i] : first_use[i];
    for_each_read(s, [&](int read) {
      int& use = first_use[static_cast<std::size_t>(read)];
      use = std::min(use, target[i]);
    });
  }

  std::vector<int> kept(n);
  std::iota(kept.begin(), kept.end(), 0);
  const std::vector<int> same = kept;
  std::stable_sort(kept.begin(), kept.end(), [&](int a, int b) {
    return target[static_cast<std::size_t>(a)] < target[static_cast<std::size_t>(b)];
  });
  Program result = rearrange(std::move(p), kept, same);
  for (std::size_t k = 0; k < n; ++k)
    result.statements[k].section = section_of[static_cast<std::size_t>(target[static_cast<std::size_t>(kept[k])])];
  return result;
}

}  // namespace robcogen::pass
