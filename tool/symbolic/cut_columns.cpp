// The stages of functions that solve for columns.
#include <algorithm>
#include <string>
#include <utility>

#include "support/index.h"
#include "symbolic/cut_program.h"

namespace robcogen::symbolic {
namespace {

// Columns that are solved for together keep their elements in registers.
constexpr int kMaxColumns = 3, kMaxElements = 126;

int begin_of(const std::vector<InputArray>& inputs, const std::string& name) {
  int begin = 0;
  for (const InputArray& input : inputs) {
    if (input.name == name) break;
    begin += static_cast<int>(input.elements.size());
  }
  return begin;
}

InputArray array(const char* name, int size) {
  InputArray result{name, Role::value, {}};
  for (int k = 0; k < size; ++k) result.elements.push_back(std::to_string(k));
  return result;
}

// Solves for `count` columns: the solution of one, once for each. `factor`: the first of its elements in the workspace.
Program solution_of(const Program& one, int count, int workspace, int factor) {
  const int rows = one.outputs.front().rows, b = begin_of(one.inputs, "b"), f = begin_of(one.inputs, "factor");
  Program p;
  p.name = one.name + (count > 1 ? "_" + std::to_string(count) : "");
  p.inputs = {array(kWorkspace, workspace), array(kColumns, count * rows)};
  p.outputs = {{kColumns, Role::matrix, rows, count, {}}};
  p.constants = one.constants;
  p.sections = one.sections;
  const auto is_of_b = [&](const Operand& o) { return o.index >= b && o.index < b + rows; };
  std::vector<std::vector<int>> places;  // by statement, by column
  const auto moved = [&](Operand o, int column) {
    if (is_statement(o)) o.index = places[at(o.index)][at(column)];
    if (o.kind == Operand::Kind::input)
      o.index = is_of_b(o) ? workspace + column * rows + o.index - b : factor + o.index - f;
    return o;
  };
  for (const Statement& s : one.statements) {
    bool is_same = true;  // in all columns
    for_each_operand(s, [&](const Operand& o) {
      if (is_statement(o)) is_same = is_same && places[at(o.index)].front() == places[at(o.index)].back();
      if (o.kind == Operand::Kind::input) is_same = is_same && !is_of_b(o);
    });
    std::vector<int>& place = places.emplace_back();
    for (int column = 0; column < count; ++column) {
      if (column == 0 || count == 1 || !is_same) {
        Statement copy = s;
        for_each_operand(copy, [&](Operand& o) { o = moved(o, column); });
        if (!s.name.empty() && column > 0) copy.name += "_" + std::to_string(column + 1);
        p.statements.push_back(std::move(copy));
      }
      place.push_back(static_cast<int>(p.statements.size()) - 1);
    }
  }
  for (int column = 0; column < count; ++column)
    for (const Operand& o : one.outputs.front().values) p.outputs.front().values.push_back(moved(o, column));
  return p;
}

// Elements of the factor become elements of the workspace from `begin` on, which is the end of the others.
void keep_factor(Program& p, const std::string& name, int begin, int size) {
  const auto named = [&](const std::string& array) {
    return std::find_if(p.outputs.begin(), p.outputs.end(), [&](const OutputArray& o) { return o.name == array; });
  };
  std::vector<Operand> factor(at(size), kNotWritten);
  bool is_written = false;
  if (const auto array = named(name); array != p.outputs.end()) {
    factor = std::move(array->values);
    p.outputs.erase(array);
    is_written = true;
  }
  if (named(kWorkspace) == p.outputs.end()) {
    if (!is_written) return;
    p.outputs.push_back({kWorkspace, Role::value, 0, 1, std::vector<Operand>(at(begin), kNotWritten)});
  }
  OutputArray& workspace = *named(kWorkspace);
  workspace.values.insert(workspace.values.end(), factor.begin(), factor.end());
  workspace.rows = begin + size;
}

}  // namespace

Stages cut_program(const Program& right_sides, const SolvedColumns& solved, int longest) {
  Stages stages = cut_program(right_sides, longest);
  const OutputArray& factor = right_sides.outputs.back();
  const int begin = stages.workspace, size = factor.rows * factor.columns;
  const int rows = solved.solution.outputs.front().rows;
  stages.workspace += size;
  for (Stage& stage : stages.list) {
    keep_factor(stage.program, factor.name, begin, size);
    stage.program.inputs.back() = array(kWorkspace, stages.workspace);
  }

  const int most = std::clamp(kMaxElements / rows, 1, kMaxColumns);
  std::vector<Stage> by_columns(at(most) + 1);
  for (const SolvedColumns::Block& block : solved.blocks) {
    for (int done = 0; done < block.columns;) {
      const int left = block.columns - done, each = std::min(left, most), runs = left / each;
      if (by_columns[at(each)].columns.empty())
        by_columns[at(each)] = {solution_of(solved.solution, each, stages.workspace, begin)};
      by_columns[at(each)].columns.push_back({block.output, done * rows, each * rows, runs});
      done += runs * each;
    }
  }
  for (std::size_t each = by_columns.size(); each-- > 0;)
    if (!by_columns[each].columns.empty()) stages.list.push_back(std::move(by_columns[each]));
  return stages;
}

}  // namespace robcogen::symbolic
