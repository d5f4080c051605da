// Rewrites a program's list of statements: shared by the passes on statements.
#pragma once

#include <vector>

#include "symbolic/program.h"

namespace robcogen::pass {

// The program with only these statements, in this order (operands before users), renumbered. `replacement[i]` is the
// statement that stands for statement i; a statement that is kept stands for itself.
symbolic::Program rearrange(
    symbolic::Program program,
    const std::vector<int>& kept,
    const std::vector<int>& replacement);

// Drops statements that no output needs.
symbolic::Program eliminate_dead_code(symbolic::Program program);

// Calls f on every operand that reads a statement.
template <class F>
void for_each_read(const symbolic::Statement& s, F f) {
  symbolic::for_each_operand(s, [&](const symbolic::Operand& o) {
    if (symbolic::is_statement(o)) f(o.index);
  });
}

// How often each statement is read, outputs included.
std::vector<int> use_counts(const symbolic::Program& program);

// Which sums are read by one statement only, which is a sum of the same width. `uses`: by statement.
std::vector<bool> inner_sums(const symbolic::Program& program, const std::vector<int>& uses);

// Sets `terms` to the terms of a sum, including those of its inner sums.
void terms_of(
    const symbolic::Program& program,
    const std::vector<bool>& inner,
    int sum,
    std::vector<symbolic::Operand>& terms);

}  // namespace robcogen::pass
