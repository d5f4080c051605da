#include "symbolic/rebuild.h"

#include <utility>

#include "support/index.h"
#include "symbolic/apply.h"

namespace robcogen::symbolic {

Rebuild::Rebuild(const Program& program, std::size_t place, const InputArray& added)
    : program_(program),
      inputs_(program.inputs),
      added_(static_cast<int>(added.elements.size())),
      values_(program.statements.size()) {
  for (std::size_t k = 0; k < place; ++k) place_ += static_cast<int>(program.inputs[k].elements.size());
  if (added_ > 0) inputs_.insert(inputs_.begin() + static_cast<std::ptrdiff_t>(place), added);
}

Expression Rebuild::read(const Operand& o) {
  const Expression e = is_constant(o)                   ? graph.constant(program_.constants[at(o.index)])
                       : o.kind == Operand::Kind::input ? input(o.index)
                                                        : values_[at(o.index)];
  return o.negative ? -e : e;
}

Expression Rebuild::compute(std::size_t i) {
  const Statement& s = program_.statements[i];
  // The operands are read one after the other, so that every compiler creates the nodes in the order of the program.
  const Expression a = read(s.a);
  const Expression b = is_binary(s.op) ? read(s.b) : Expression();
  return apply(s.op, a, b);
}

void Rebuild::set(std::size_t i, const Expression& value) {
  values_[i] = value;
  const Statement& s = program_.statements[i];
  if (s.named) graph.name(value, s.name);
  if (s.described) graph.describe(value, s.name);
}

void Rebuild::enter_section_of(std::size_t i) {
  if (program_.statements[i].section == section_) return;
  section_ = program_.statements[i].section;
  const Section& section = program_.sections[at(section_)];
  graph.begin_section(section.title, section.prefix);
}

void Rebuild::keep_all() {
  for (std::size_t i = 0; i < program_.statements.size(); ++i) {
    enter_section_of(i);
    set(i, compute(i));
  }
}

std::vector<std::vector<Expression>> Rebuild::outputs() {
  std::vector<std::vector<Expression>> values;
  for (const OutputArray& array : program_.outputs) {
    std::vector<Expression>& list = values.emplace_back();
    for (const Operand& o : array.values) list.push_back(read(o));
  }
  return values;
}

Program Rebuild::finish(std::vector<OutputArray> shapes, const std::vector<std::vector<Expression>>& values) const {
  for (OutputArray& shape : shapes) shape.values.clear();
  return graph.program(program_.name, inputs_, std::move(shapes), values);
}

std::vector<std::vector<Expression>> outputs_of(
    Graph& graph,
    const Program& program,
    const std::vector<Expression>& inputs) {
  std::vector<Expression> values;
  const auto read = [&](const Operand& o) {
    const Expression e = is_constant(o)                   ? graph.constant(program.constants[at(o.index)])
                         : o.kind == Operand::Kind::input ? inputs[at(o.index)]
                                                          : values[at(o.index)];
    return o.negative ? -e : e;
  };
  for (const Statement& s : program.statements) {
    const Expression a = read(s.a), b = is_binary(s.op) ? read(s.b) : Expression();
    values.push_back(apply(s.op, a, b));
  }
  std::vector<std::vector<Expression>> outputs;
  for (const OutputArray& array : program.outputs) {
    std::vector<Expression>& list = outputs.emplace_back();
    for (const Operand& o : array.values) list.push_back(read(o));
  }
  return outputs;
}

}  // namespace robcogen::symbolic
