#include "symbolic/cut_program.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "support/index.h"

namespace robcogen::symbolic {
namespace {

// The instructions that a GPU starts while its memory delivers or takes one number of four bytes: of an H100, 132 * 128
// * 1.755e9 a second, and 3.0e12 bytes.
constexpr int kNumber = 40;
// Whatever is computed from an input again shares its load with others.
constexpr int kInput = kNumber / 2;
// The cost of starting a stage, as a number of values that are passed on.
constexpr int kStart = 8;

int instructions(Op op) {
  switch (op) {
    case Op::sine:
    case Op::cosine:
      return 10;  // half of both
    case Op::divide:
    case Op::square_root:
      return 8;
    case Op::arc_tangent:
      return kNumber;
    default:
      return 1;
  }
}

// Calls f on every operand that is a statement.
template <class F>
void for_each_read(const Statement& s, F f) {
  for_each_operand(s, [&](const Operand& o) {
    if (is_statement(o)) f(at(o.index));
  });
}

// By statement: the instructions that it takes to compute it from inputs, where no other value is at hand, or to pass
// it from the stage that computes it to another one.
std::vector<int> costs_alone(const Program& p) {
  std::vector<int> costs;
  for (const Statement& s : p.statements) {
    int cost = instructions(s.op);
    for_each_operand(s, [&](const Operand& o) {
      if (is_statement(o)) cost += costs[at(o.index)];
      if (o.kind == Operand::Kind::input) cost += kInput;
    });
    costs.push_back(std::min(cost, 2 * kNumber));
  }
  return costs;
}

// The stage of each statement, ascending, such that stages read few values of others. Values that are computed from
// inputs sooner than they are read do not count.
std::vector<int> stages_of(const Program& p, const std::vector<int>& costs, int longest) {
  const std::size_t n = p.statements.size(), most = at(longest);
  std::vector<std::vector<std::size_t>> reads(n);
  for (std::size_t i = 0; i < n; ++i)
    for_each_read(p.statements[i], [&](std::size_t read) {
      if (costs[read] > kNumber) reads[i].push_back(read);
    });
  std::vector<std::size_t> cost(n + 1, std::numeric_limits<std::size_t>::max()), from(n + 1, 0), seen(n, 0);
  cost[0] = 0;
  for (std::size_t end = 1; end <= n; ++end) {
    std::size_t count = 0;  // values that statements from `begin` to `end` read from before
    for (std::size_t begin = end; begin-- > 0 && end - begin <= most;) {
      if (seen[begin] == end) --count;
      for (const std::size_t read : reads[begin])
        if (std::exchange(seen[read], end) != end) ++count;
      if (const std::size_t sum = cost[begin] + count + kStart; sum < cost[end]) {
        cost[end] = sum;
        from[end] = begin;
      }
    }
  }
  std::vector<int> stage(n);
  int stages = 0;
  for (std::size_t end = n; end > 0; end = from[end]) ++stages;
  for (std::size_t end = n; end > 0; end = from[end]) {
    --stages;
    for (std::size_t i = from[end]; i < end; ++i) stage[i] = stages;
  }
  return stage;
}

class ProgramCutter {
 public:
  ProgramCutter(const Program& p, int longest)
      : p_(p),
        alone_(costs_alone(p)),
        stage_(stages_of(p, alone_, longest)),
        readers_(p.statements.size()),
        slot_(p.statements.size(), -1) {}

  Stages run() {
    const int count = p_.statements.empty() ? 1 : stage_.back() + 1;
    decide(count);
    Stages result;
    result.workspace = place_values(count);
    // Stages write nothing if later ones compute all of their values again.
    for (int s = 0; s < count; ++s)
      if (Stage next = stage(s, s + 1 == count, result.workspace); !next.program.outputs.empty())
        result.list.push_back(std::move(next));
    return result;
  }

 private:
  const Program& p_;
  std::vector<int> alone_;                 // by statement: its cost in a stage where no other value is at hand
  std::vector<int> stage_;                 // by statement
  std::vector<std::vector<int>> readers_;  // by statement: the other stages that need it
  std::vector<bool> is_kept_;              // by statement: passed through the workspace, not computed again
  std::vector<int> slot_;                  // by statement that is kept: its element of the workspace

  bool is_in(int statement, int s) const {
    const std::vector<int>& readers = readers_[at(statement)];
    return stage_[at(statement)] == s || std::find(readers.begin(), readers.end(), s) != readers.end();
  }
  void need(int statement, int s) {
    if (!is_in(statement, s)) readers_[at(statement)].push_back(s);
  }

  // Users come before their operands, so that all stages that need a value are known.
  void decide(int count) {
    is_kept_.assign(p_.statements.size(), false);
    std::vector<std::vector<bool>> reads(at(count), std::vector<bool>(at(p_.input_count()), false));
    const auto note = [&](const Statement& s, int stage) {
      for_each_operand(s, [&](const Operand& o) {
        if (is_statement(o)) need(o.index, stage);
        if (o.kind == Operand::Kind::input) reads[at(stage)][at(o.index)] = true;
      });
    };
    for (std::size_t i = 0; i < p_.statements.size(); ++i) note(p_.statements[i], stage_[i]);
    for (std::size_t i = p_.statements.size(); i-- > 0;) {
      const Statement& statement = p_.statements[i];
      const int passed = kNumber * static_cast<int>(readers_[i].size() + 1);
      int computed = 0;
      for (const int s : readers_[i]) {
        computed += instructions(statement.op);
        for_each_operand(statement, [&](const Operand& o) {
          if (is_statement(o) && !is_in(o.index, s))
            computed += readers_[at(o.index)].empty() ? alone_[at(o.index)] : std::min(alone_[at(o.index)], kNumber);
          if (o.kind == Operand::Kind::input && !reads[at(s)][at(o.index)]) computed += kInput;
        });
      }
      is_kept_[i] = computed >= passed;
      if (is_kept_[i]) continue;
      for (const int s : readers_[i]) note(statement, s);
    }
  }

  // An element is free for another value after the last stage that reads it. Returns the size of the workspace.
  int place_values(int count) {
    std::vector<std::vector<int>> begins(at(count)), ends(at(count));  // by stage: statements
    for (std::size_t i = 0; i < readers_.size(); ++i) {
      if (!is_kept_[i] || readers_[i].empty()) continue;
      begins[at(stage_[i])].push_back(static_cast<int>(i));
      ends[at(*std::max_element(readers_[i].begin(), readers_[i].end()))].push_back(static_cast<int>(i));
    }
    int size = 0;
    std::vector<int> free;
    for (std::size_t s = 0; s < begins.size(); ++s) {
      for (const int i : begins[s]) {
        if (free.empty()) free.push_back(size++);
        slot_[at(i)] = free.back();
        free.pop_back();
      }
      for (const int i : ends[s]) free.push_back(slot_[at(i)]);
    }
    return size;
  }

  // Statements of stage s that its outputs need, and those that it computes again.
  std::vector<bool> needed(int s) const {
    std::vector<bool> result(p_.statements.size(), false);
    for (const OutputArray& output : p_.outputs)
      for (const Operand& o : output.values)
        if (is_statement(o) && stage_[at(o.index)] == s) result[at(o.index)] = true;
    for (std::size_t i = result.size(); i-- > 0;) {
      const bool is_own = stage_[i] == s;
      result[i] = is_own ? result[i] || slot_[i] >= 0 : result[i] && !is_kept_[i];
      if (result[i]) for_each_read(p_.statements[i], [&](std::size_t read) { result[read] = true; });
    }
    return result;
  }

  Stage stage(int s, bool is_last, int workspace) const {
    Stage result;
    Program& p = result.program;
    p.name = p_.name + "_" + std::to_string(s + 1);
    p.inputs = p_.inputs;
    p.inputs.push_back({kWorkspace, Role::value, {}});
    for (int k = 0; k < workspace; ++k) p.inputs.back().elements.push_back(std::to_string(k));
    p.sections = p_.sections;

    std::vector<int> place(p_.statements.size(), -1);
    std::map<int, int> constants;
    const int inputs = p_.input_count();
    const auto move = [&](Operand& o) {
      if (is_constant(o)) {
        const auto [constant, is_new] = constants.insert({o.index, static_cast<int>(constants.size())});
        if (is_new) p.constants.push_back(p_.constants[at(o.index)]);
        o.index = constant->second;
      } else if (is_statement(o) && place[at(o.index)] >= 0) {
        o.index = place[at(o.index)];
      } else if (is_statement(o)) {
        o = {Operand::Kind::input, inputs + slot_[at(o.index)], o.negative};
      }
    };
    const std::vector<bool> is_needed = needed(s);
    for (std::size_t i = 0; i < p_.statements.size(); ++i) {
      if (!is_needed[i]) continue;
      place[i] = static_cast<int>(p.statements.size());
      for_each_operand(p.statements.emplace_back(p_.statements[i]), move);
    }

    // Elements that are no statements are written last.
    for (const OutputArray& output : p_.outputs) {
      OutputArray part = output;
      bool is_written = false;
      for (Operand& o : part.values) {
        const bool is_here = is_statement(o) ? stage_[at(o.index)] == s : is_last;
        is_written = is_written || is_here;
        if (is_here)
          move(o);
        else
          o = kNotWritten;
      }
      if (is_written) p.outputs.push_back(std::move(part));
    }
    OutputArray passed = {kWorkspace, Role::value, workspace, 1, std::vector<Operand>(at(workspace), kNotWritten)};
    bool is_written = false;
    for (std::size_t i = 0; i < p_.statements.size(); ++i) {
      if (stage_[i] != s || slot_[i] < 0) continue;
      passed.values[at(slot_[i])] = {Operand::Kind::statement, place[i]};
      is_written = true;
    }
    if (is_written) p.outputs.push_back(std::move(passed));
    return result;
  }
};

}  // namespace

Stages cut_program(const Program& program, int longest) {
  return ProgramCutter(program, longest).run();
}

}  // namespace robcogen::symbolic
