#include "symbolic/cut_outputs.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "support/index.h"

namespace robcogen::symbolic {
namespace {

using Needed = std::vector<bool>;  // by statement

class OutputCutter {
 public:
  OutputCutter(
      const Program& p,
      const std::vector<OutputElements>& in_turn,
      const std::vector<StageOnDemand>& on_demand)
      : p_(p), in_turn_(in_turn), on_demand_(on_demand), slot_(p.statements.size(), -1) {}

  Stages run() {
    choose_stages();
    Stages result;
    std::vector<Needed> computed;
    for (std::size_t k = 0; k < in_turn_.size(); ++k) {
      Needed own(p_.statements.size());
      for (std::size_t i = 0; i < own.size(); ++i) own[i] = stage_[i] == static_cast<int>(k);
      computed.push_back(std::move(own));
    }
    for (const StageOnDemand& stage : on_demand_) {
      Needed own = needed_by(stage.elements);
      for (std::size_t i = 0; i < own.size(); ++i) own[i] = own[i] && stage_[i] < 0;
      computed.push_back(std::move(own));
    }
    for (std::size_t s = 0; s < computed.size(); ++s) note_passed(elements_of(s), computed[s], result.workspace);
    for (std::size_t s = 0; s < computed.size(); ++s)
      result.list.push_back(stage(s, elements_of(s), computed[s], result.workspace));
    return result;
  }

 private:
  const Program& p_;
  const std::vector<OutputElements>& in_turn_;
  const std::vector<StageOnDemand>& on_demand_;
  std::vector<int> stage_;  // by statement: the stage in turn that computes it, or -1
  std::vector<int> slot_;   // by statement that other stages read: its element of the workspace

  const OutputElements& elements_of(std::size_t s) const {
    return s < in_turn_.size() ? in_turn_[s] : on_demand_[s - in_turn_.size()].elements;
  }

  const Operand& value_of(const std::array<int, 2>& element) const {
    return p_.outputs[at(element[0])].values[at(element[1])];
  }

  Needed needed_by(const OutputElements& elements) const {
    Needed result(p_.statements.size(), false);
    for (const std::array<int, 2>& element : elements)
      if (const Operand& o = value_of(element); is_statement(o)) result[at(o.index)] = true;
    for (std::size_t i = result.size(); i-- > 0;)
      if (result[i])
        for_each_operand(p_.statements[i], [&](const Operand& o) {
          if (is_statement(o)) result[at(o.index)] = true;
        });
    return result;
  }

  void choose_stages() {
    constexpr int kNone = 1 << 30;
    std::vector<int> first(p_.statements.size(), kNone);
    const auto need = [&](const Needed& needed, int stage, bool is_shared) {
      for (std::size_t i = 0; i < needed.size(); ++i)
        if (needed[i] && (!is_shared || first[i] != kNone)) first[i] = std::min(first[i], stage);
    };
    for (std::size_t k = 0; k < in_turn_.size(); ++k) need(needed_by(in_turn_[k]), static_cast<int>(k), false);
    for (const StageOnDemand& stage : on_demand_) need(needed_by(stage.elements), stage.after, true);
    for (const int stage : first) stage_.push_back(stage == kNone ? -1 : stage);
  }

  // Gives the values that the stage reads from others their places.
  void note_passed(const OutputElements& elements, const Needed& computed, int& workspace) {
    const auto note = [&](const Operand& o) {
      if (is_statement(o) && !computed[at(o.index)] && slot_[at(o.index)] < 0) slot_[at(o.index)] = workspace++;
    };
    for (std::size_t i = 0; i < computed.size(); ++i)
      if (computed[i]) for_each_operand(p_.statements[i], note);
    for (const std::array<int, 2>& element : elements) note(value_of(element));
  }

  Stage stage(std::size_t s, const OutputElements& elements, const Needed& computed, int workspace) const {
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
    const auto moved = [&](Operand o) {
      if (is_constant(o)) {
        const auto [constant, is_new] = constants.insert({o.index, static_cast<int>(constants.size())});
        if (is_new) p.constants.push_back(p_.constants[at(o.index)]);
        o.index = constant->second;
      } else if (is_statement(o) && place[at(o.index)] >= 0) {
        o.index = place[at(o.index)];
      } else if (is_statement(o)) {
        o = {Operand::Kind::input, inputs + slot_[at(o.index)], o.negative};
      }
      return o;
    };
    for (std::size_t i = 0; i < p_.statements.size(); ++i) {
      if (!computed[i]) continue;
      place[i] = static_cast<int>(p.statements.size());
      for_each_operand(p.statements.emplace_back(p_.statements[i]), [&](Operand& o) { o = moved(o); });
    }

    for (std::size_t k = 0; k < p_.outputs.size(); ++k) {
      OutputArray part = p_.outputs[k];
      std::fill(part.values.begin(), part.values.end(), kNotWritten);
      bool is_written = false;
      for (const std::array<int, 2>& element : elements) {
        if (at(element[0]) != k) continue;
        part.values[at(element[1])] = moved(value_of(element));
        is_written = true;
      }
      if (is_written) p.outputs.push_back(std::move(part));
    }
    OutputArray passed = {kWorkspace, Role::value, workspace, 1, std::vector<Operand>(at(workspace), kNotWritten)};
    bool is_written = false;
    for (std::size_t i = 0; i < p_.statements.size(); ++i) {
      if (stage_[i] != static_cast<int>(s) || slot_[i] < 0) continue;
      passed.values[at(slot_[i])] = {Operand::Kind::statement, place[i]};
      is_written = true;
    }
    if (is_written) p.outputs.push_back(std::move(passed));
    return result;
  }
};

}  // namespace

Stages cut_outputs(
    const Program& program,
    const std::vector<OutputElements>& in_turn,
    const std::vector<StageOnDemand>& on_demand) {
  return OutputCutter(program, in_turn, on_demand).run();
}

}  // namespace robcogen::symbolic
