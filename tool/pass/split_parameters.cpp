#include "pass/split_parameters.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "pass/gather_parameters.h"
#include "pass/read_angles.h"
#include "support/index.h"
#include "support/unique_names.h"
#include "symbolic/parameter_values.h"
#include "symbolic/rebuild.h"
#include "symbolic/text.h"

namespace robcogen::pass {
namespace {

using symbolic::Expression;
using symbolic::Graph;
using symbolic::InputArray;
using symbolic::Node;
using symbolic::Operand;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Rebuild;
using symbolic::Role;

// A program with parameters, and its values that depend on them alone.
struct Half {
  const Program* program;
  InputPlace parameters;
  std::vector<char> follows;  // by statement: whether it depends on parameters alone
  Rebuild values;             // of these statements

  bool is_given(const Operand& o) const {
    return is_constant(o) || (is_statement(o) ? follows[at(o.index)] : parameters.contains(o.index));
  }
};

// The values of all programs that depend on the parameters alone, in one graph whose inputs are the parameters.
class Derived {
 public:
  // Adds the values of a program, and keeps those that the rest of the program reads.
  Half add(const Program& program) {
    const InputPlace parameters = place_of(program, Role::parameters);
    const auto parameter = [this, parameters](const Operand& o) -> std::optional<Expression> {
      if (o.kind != Operand::Kind::input) return std::nullopt;
      const Expression value = graph_.input(o.index - parameters.begin);
      names_.insert({value.node(), parameters.array->elements[at(o.index - parameters.begin)]});
      return value;
    };
    Half half{&program, parameters, symbolic::follow_from_parameters(program), Rebuild(graph_, program, parameter)};
    const auto keep_given = [&](const Operand& o) {
      if (half.is_given(o)) keep(half.values.read(o));
    };
    const std::vector<std::string> names = symbolic::statement_names(program);
    for (std::size_t i = 0; i < program.statements.size(); ++i) {
      if (!half.follows[i]) {
        for_each_operand(program.statements[i], keep_given);
        continue;
      }
      half.values.keep(i);
      const Expression value = half.values.read({Operand::Kind::statement, static_cast<int>(i)});
      if (!value.is_constant()) names_.insert({value.node(), names[i]});
    }
    for (const OutputArray& array : program.outputs)
      for (const Operand& o : array.values) keep_given(o);
    return half;
  }

  // Keeps the value in the cache.
  void keep(const Expression& value) {
    if (!value.is_constant() && kept_.insert(value.node()).second) order_.push_back(value.negative() ? -value : value);
  }

  // Orders the values in the cache: first those that depend on kinematics parameters alone, then those that depend on
  // dynamics parameters alone, then those that depend on both.
  void arrange(const std::vector<Interfaces>& interfaces) {
    std::vector<unsigned> uses;  // by node: bit 0 kinematics, bit 1 dynamics
    for (const Node& n : graph_.nodes()) {
      unsigned mask = 0;
      if (n.kind == Node::Kind::input) {
        const Interfaces& of = interfaces[at(n.a)];
        mask = (of.kinematics ? 1U : 0U) | (of.dynamics ? 2U : 0U);
      }
      if (n.kind == Node::Kind::operation) {
        mask = uses[at(n.a)];
        if (symbolic::is_binary(n.op)) mask |= uses[at(n.b)];
      }
      uses.push_back(mask);
    }
    for (const unsigned part : {1U, 2U, 3U}) {
      std::vector<Expression>& values = parts_[part - 1];
      for (const Expression& value : order_)
        if (uses[at(value.node())] == part) values.push_back(value);
      for (const Expression& value : values) {
        places_[value.node()] = static_cast<int>(labels_.size());
        labels_.push_back(label(value));
      }
    }
  }

  int place(const Expression& value) const { return places_.at(value.node()); }
  const std::vector<std::string>& labels() const { return labels_; }

  Program part(std::size_t index, const std::string& name, const InputArray& parameters) const {
    const int rows = static_cast<int>(parts_[index].size());
    return graph_.program(name, {parameters}, {{"cache", Role::value, rows, 1, {}}}, {parts_[index]});
  }

 private:
  // The name that a statement gave the value, or the name of its parameter; numbered if another value has it.
  std::string label(const Expression& value) { return taken_.add(names_.at(value.node())); }

  Graph graph_;
  std::map<int, std::string> names_;  // by node
  std::set<int> kept_;
  std::vector<Expression> order_;
  std::vector<Expression> parts_[3];
  std::map<int, int> places_;  // by node
  std::vector<std::string> labels_;
  UniqueNames taken_;
};

// The rest of a program, which reads the cache.
Program rest(Half& half, const Derived& derived) {
  const Program& program = *half.program;
  const InputPlace& parameters = half.parameters;
  const int grown = static_cast<int>(derived.labels().size()) - parameters.size();
  Graph graph;
  const auto cached = [&](const Operand& o) -> std::optional<Expression> {
    if (is_constant(o)) return std::nullopt;
    if (half.is_given(o)) {
      const Expression value = half.values.read(o);
      if (value.is_constant()) return graph.constant(value.constant());
      const Expression element = graph.input(parameters.begin + derived.place(value));
      return value.negative() ? -element : element;
    }
    if (is_statement(o)) return std::nullopt;
    return graph.input(o.index < parameters.begin ? o.index : o.index + grown);
  };
  Rebuild rebuild(graph, program, cached);
  for (std::size_t i = 0; i < program.statements.size(); ++i)
    if (!half.follows[i]) rebuild.keep(i);
  std::vector<InputArray> inputs = program.inputs;
  inputs[static_cast<std::size_t>(parameters.array - program.inputs.data())].elements = derived.labels();
  return rebuild.finish(std::move(inputs), program.outputs, rebuild.outputs());
}

}  // namespace

SplitPrograms split_parameters(std::vector<Program> programs, const std::vector<Interfaces>& interfaces) {
  Derived derived;
  std::vector<std::optional<Half>> halves;
  InputArray parameters = {"parameters", Role::parameters, {}};
  for (Program& program : programs) {
    std::optional<Half>& half = halves.emplace_back();
    if (!place_of(program, Role::parameters).array) continue;
    program = gather_parameters(program);
    half.emplace(derived.add(program));
    parameters = *half->parameters.array;
  }
  derived.arrange(interfaces);

  // Each program is replaced by its rest at once: those of large robots take hundreds of megabytes.
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (!halves[i]) continue;
    programs[i] = rest(*halves[i], derived);
    halves[i].reset();
  }
  SplitPrograms result;
  result.programs = std::move(programs);
  result.kinematics = derived.part(0, "update_kinematics", parameters);
  result.dynamics = derived.part(1, "update_dynamics", parameters);
  result.both = derived.part(2, "update_both", parameters);
  return result;
}

}  // namespace robcogen::pass
