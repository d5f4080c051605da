#include "pass/split_parameters.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "pass/gather_parameters.h"
#include "pass/statements.h"
#include "support/unique_names.h"
#include "symbolic/apply.h"
#include "symbolic/expression.h"

namespace robcogen::pass {
namespace {

using symbolic::Expression;
using symbolic::Graph;
using symbolic::InputArray;
using symbolic::Node;
using symbolic::Operand;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;
using symbolic::Statement;

// The flat indices of the parameters among a program's input elements.
struct Range {
  int begin = 0;
  int end = 0;
  bool contains(int element) const { return element >= begin && element < end; }
};

std::optional<Range> parameters_of(const Program& program) {
  int begin = 0;
  for (const InputArray& array : program.inputs) {
    const int end = begin + static_cast<int>(array.elements.size());
    if (array.role == Role::parameters) return Range{begin, end};
    begin = end;
  }
  return std::nullopt;
}

// The values of all programs that depend on the parameters alone, in one graph whose inputs are the parameters.
class Derived {
 public:
  // Values of the statements of a program that read nothing but parameters and constants; nullopt for the others.
  std::vector<std::optional<Expression>> add(const Program& program, const Range& parameters) {
    std::vector<std::optional<Expression>> values(program.statements.size());
    int section = -1;
    for (std::size_t i = 0; i < program.statements.size(); ++i) {
      const Statement& s = program.statements[i];
      const auto a = read(program, parameters, values, s.a);
      const auto b = symbolic::is_binary(s.op) ? read(program, parameters, values, s.b) : Expression();
      if (!a || !b) continue;
      if (s.section != section) {
        section = s.section;
        const symbolic::Section& title = program.sections[static_cast<std::size_t>(section)];
        graph_.begin_section(title.title, title.prefix);
      }
      values[i] = symbolic::apply(s.op, *a, *b);
      if (s.named) graph_.name(*values[i], s.name);
      if (s.described) graph_.describe(*values[i], s.name);
      if (!values[i]->is_constant()) names_.insert({values[i]->node(), s.name});
    }
    return values;
  }

  // The value of an operand that reads nothing but parameters and constants.
  std::optional<Expression> read(
      const Program& program,
      const Range& parameters,
      const std::vector<std::optional<Expression>>& values,
      const Operand& o) {
    const auto i = static_cast<std::size_t>(o.index);
    std::optional<Expression> value;
    if (is_constant(o)) value = graph_.constant(program.constants[i]);
    if (is_statement(o)) value = values[i];
    if (o.kind == Operand::Kind::input && parameters.contains(o.index)) {
      value = graph_.input(o.index - parameters.begin);
      const InputArray& array = *std::find_if(
          program.inputs.begin(), program.inputs.end(),
          [](const InputArray& input) { return input.role == Role::parameters; });
      names_.insert({value->node(), array.elements[static_cast<std::size_t>(o.index - parameters.begin)]});
    }
    if (value && o.negative) value = -*value;
    return value;
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
        const Interfaces& of = interfaces[static_cast<std::size_t>(n.a)];
        mask = (of.kinematics ? 1U : 0U) | (of.dynamics ? 2U : 0U);
      }
      if (n.kind == Node::Kind::operation) {
        mask = uses[static_cast<std::size_t>(n.a)];
        if (symbolic::is_binary(n.op)) mask |= uses[static_cast<std::size_t>(n.b)];
      }
      uses.push_back(mask);
    }
    for (const unsigned part : {1U, 2U, 3U}) {
      std::vector<Expression>& values = parts_[part - 1];
      for (const Expression& value : order_)
        if (uses[static_cast<std::size_t>(value.node())] == part) values.push_back(value);
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

// One program, and its values that follow from the parameters.
struct Half {
  const Program* program;
  std::optional<Range> parameters;
  std::vector<std::optional<Expression>> values;
};

// Calls f on every operand of the remaining statements, and on every element of an output.
template <class F>
void for_each_operand_left(const Half& half, F f) {
  for (std::size_t i = 0; i < half.program->statements.size(); ++i) {
    if (half.values[i]) continue;
    const Statement& s = half.program->statements[i];
    f(s.a);
    if (symbolic::is_binary(s.op)) f(s.b);
  }
  for (const OutputArray& array : half.program->outputs)
    for (const Operand& o : array.values) f(o);
}

// Rebuilds the rest of a program, which reads the cache.
class Rest {
 public:
  Rest(const Half& half, Derived& derived) : half_(half), derived_(derived), left_(half.program->statements.size()) {}

  Program build() {
    const Program& program = *half_.program;
    int section = -1;
    for (std::size_t i = 0; i < program.statements.size(); ++i) {
      if (half_.values[i]) continue;
      const Statement& s = program.statements[i];
      if (s.section != section) {
        section = s.section;
        const symbolic::Section& title = program.sections[static_cast<std::size_t>(section)];
        graph_.begin_section(title.title, title.prefix);
      }
      const Expression a = read(s.a);
      const Expression b = symbolic::is_binary(s.op) ? read(s.b) : Expression();
      left_[i] = symbolic::apply(s.op, a, b);
      if (s.named) graph_.name(left_[i], s.name);
      if (s.described) graph_.describe(left_[i], s.name);
    }
    std::vector<OutputArray> shapes = program.outputs;
    std::vector<std::vector<Expression>> outputs;
    for (OutputArray& array : shapes) {
      std::vector<Expression>& values = outputs.emplace_back();
      for (const Operand& o : array.values) values.push_back(read(o));
      array.values.clear();
    }
    std::vector<InputArray> inputs = program.inputs;
    for (InputArray& array : inputs)
      if (array.role == Role::parameters) array.elements = derived_.labels();
    return graph_.program(program.name, inputs, shapes, outputs);
  }

 private:
  Expression read(const Operand& o) {
    if (const auto value = derived_.read(*half_.program, *half_.parameters, half_.values, o)) {
      if (value->is_constant()) return graph_.constant(value->constant());
      const Expression cached = graph_.input(half_.parameters->begin + derived_.place(*value));
      return value->negative() ? -cached : cached;
    }
    const int grown = static_cast<int>(derived_.labels().size()) - (half_.parameters->end - half_.parameters->begin);
    const Expression e = is_statement(o) ? left_[static_cast<std::size_t>(o.index)]
                                         : graph_.input(o.index < half_.parameters->begin ? o.index : o.index + grown);
    return o.negative ? -e : e;
  }

  const Half& half_;
  Derived& derived_;
  Graph graph_;
  std::vector<Expression> left_;
};

}  // namespace

SplitPrograms split_parameters(std::vector<Program> programs, const std::vector<Interfaces>& interfaces) {
  Derived derived;
  std::vector<Half> halves;
  InputArray parameters = {"parameters", Role::parameters, {}};
  for (Program& program : programs) {
    const std::optional<Range> range = parameters_of(program);
    if (range) program = gather_parameters(program);
    Half& half = halves.emplace_back(Half{&program, range, {}});
    if (!range) continue;
    for (const InputArray& array : program.inputs)
      if (array.role == Role::parameters) parameters = array;
    half.values = derived.add(program, *range);
    for_each_operand_left(half, [&](const Operand& o) {
      if (const auto value = derived.read(program, *range, half.values, o)) derived.keep(*value);
    });
  }
  derived.arrange(interfaces);

  // Each program is replaced by its rest at once: those of large robots take hundreds of megabytes.
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (!halves[i].parameters) continue;
    Program rest = Rest(halves[i], derived).build();
    programs[i] = std::move(rest);
    halves[i].values = {};
  }
  SplitPrograms result;
  result.programs = std::move(programs);
  result.kinematics = derived.part(0, "update_kinematics", parameters);
  result.dynamics = derived.part(1, "update_dynamics", parameters);
  result.both = derived.part(2, "update_both", parameters);
  return result;
}

}  // namespace robcogen::pass
