#include "pass/rebuild.h"

#include "symbolic/apply.h"

namespace robcogen::pass {

using symbolic::Expression;
using symbolic::Operand;
using symbolic::Statement;

Rebuild::Rebuild(const symbolic::Program& program) : program_(program), values_(program.statements.size()) {}

Expression Rebuild::read(const Operand& o) {
  const auto i = static_cast<std::size_t>(o.index);
  const Expression e = is_constant(o)                   ? graph_.constant(program_.constants[i])
                       : o.kind == Operand::Kind::input ? graph_.input(o.index)
                                                        : values_[i];
  return o.negative ? -e : e;
}

Expression Rebuild::compute(std::size_t i) {
  const Statement& s = program_.statements[i];
  // One after the other: the order in which nodes are made is the order of the program, with every compiler.
  const Expression a = read(s.a);
  const Expression b = symbolic::is_binary(s.op) ? read(s.b) : Expression();
  return symbolic::apply(s.op, a, b);
}

void Rebuild::set(std::size_t i, const Expression& value) {
  values_[i] = value;
  const Statement& s = program_.statements[i];
  if (s.named) graph_.name(value, s.name);
  if (s.described) graph_.describe(value, s.name);
}

void Rebuild::enter_section_of(std::size_t i) {
  if (program_.statements[i].section == section_) return;
  section_ = program_.statements[i].section;
  const symbolic::Section& section = program_.sections[static_cast<std::size_t>(section_)];
  graph_.begin_section(section.title, section.prefix);
}

symbolic::Program Rebuild::finish() {
  std::vector<symbolic::OutputArray> shapes = program_.outputs;
  std::vector<std::vector<Expression>> outputs;
  for (symbolic::OutputArray& array : shapes) {
    std::vector<Expression>& values = outputs.emplace_back();
    for (const Operand& o : array.values) values.push_back(read(o));
    array.values.clear();
  }
  return graph_.program(program_.name, program_.inputs, shapes, outputs);
}

}  // namespace robcogen::pass
