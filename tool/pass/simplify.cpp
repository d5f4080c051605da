#include "pass/passes.h"
#include "symbolic/expression.h"

namespace robcogen::pass {

using symbolic::Expression;
using symbolic::Op;
using symbolic::Operand;
using symbolic::Program;
using symbolic::Statement;

namespace {

Expression apply(Op op, const Expression& a, const Expression& b) {
  switch (op) {
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::square_root:
      return sqrt(a);
    case Op::sine:
      return sin(a);
    case Op::cosine:
      return cos(a);
  }
  return a;
}

}  // namespace

Program simplify(const Program& p) {
  symbolic::Graph graph;
  std::vector<Expression> value;
  value.reserve(p.statements.size());
  const auto read = [&](const Operand& o) {
    const auto i = static_cast<std::size_t>(o.index);
    const Expression e = o.kind == Operand::Kind::constant ? graph.constant(p.constants[i])
                         : o.kind == Operand::Kind::input  ? graph.input(o.index)
                                                           : value[i];
    return o.negative ? -e : e;
  };
  int section = -1;
  for (const Statement& s : p.statements) {
    if (s.section != section) {
      section = s.section;
      const symbolic::Section& here = p.sections[static_cast<std::size_t>(section)];
      graph.begin_section(here.title, here.prefix);
    }
    value.push_back(apply(s.op, read(s.a), symbolic::is_binary(s.op) ? read(s.b) : Expression()));
    if (s.named) graph.name(value.back(), s.name);
  }
  std::vector<symbolic::OutputArray> shapes = p.outputs;
  std::vector<std::vector<Expression>> outputs;
  for (symbolic::OutputArray& array : shapes) {
    std::vector<Expression>& values = outputs.emplace_back();
    for (const Operand& o : array.values) values.push_back(read(o));
    array.values.clear();
  }
  return graph.program(p.name, p.inputs, shapes, outputs);
}

}  // namespace robcogen::pass
