#include "symbolic/rebuild.h"

#include <utility>

#include "support/index.h"
#include "symbolic/interpret.h"

namespace robcogen::symbolic {

Rebuild::Rebuild(Graph& graph, const Program& program, Replacement replacement)
    : graph_(graph), program_(program), replacement_(std::move(replacement)), values_(program.statements.size()) {}

Expression Rebuild::read(const Operand& o) {
  std::optional<Expression> e;
  if (replacement_) e = replacement_({o.kind, o.index});
  if (!e)
    e = is_constant(o)                   ? graph_.constant(program_.constants[at(o.index)])
        : o.kind == Operand::Kind::input ? graph_.input(o.index)
                                         : values_[at(o.index)];
  return o.negative ? -*e : *e;
}

Expression Rebuild::compute(std::size_t i) {
  const Statement& s = program_.statements[i];
  // The operands are read one after the other, so that every compiler creates the nodes in the order of the program.
  const Expression a = read(s.a);
  return apply(s.op, a, is_binary(s.op) ? read(s.b) : a);
}

void Rebuild::set(std::size_t i, const Expression& value) {
  values_[i] = value;
  graph_.name(value, program_.statements[i]);
}

void Rebuild::enter_section_of(std::size_t i) {
  if (program_.statements[i].section == section_) return;
  section_ = program_.statements[i].section;
  const Section& section = program_.sections[at(section_)];
  graph_.begin_section(section.title, section.prefix);
}

void Rebuild::keep(std::size_t i) {
  enter_section_of(i);
  set(i, compute(i));
}

void Rebuild::keep_all() {
  for (std::size_t i = 0; i < program_.statements.size(); ++i) keep(i);
}

std::vector<std::vector<Expression>> Rebuild::outputs() {
  std::vector<std::vector<Expression>> values;
  for (const OutputArray& array : program_.outputs) {
    std::vector<Expression>& list = values.emplace_back();
    for (const Operand& o : array.values) list.push_back(read(o));
  }
  return values;
}

Program Rebuild::finish(
    std::vector<InputArray> inputs,
    std::vector<OutputArray> shapes,
    const std::vector<std::vector<Expression>>& values) const {
  for (OutputArray& shape : shapes) shape.values.clear();
  return graph_.program(program_.name, std::move(inputs), std::move(shapes), values);
}

std::vector<std::vector<Expression>> outputs_of(
    Graph& graph,
    const Program& program,
    const std::vector<Expression>& inputs) {
  const auto leaf = [&](const Operand& o) {
    return is_constant(o) ? graph.constant(program.constants[at(o.index)]) : inputs[at(o.index)];
  };
  return interpreter<Expression>(program, leaf).outputs();
}

}  // namespace robcogen::symbolic
