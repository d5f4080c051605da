#include "pass/gather_parameters.h"

#include "symbolic/rebuild.h"

namespace robcogen::pass {
namespace {

using symbolic::Expression;
using symbolic::Graph;
using symbolic::Node;
using symbolic::Op;
using symbolic::Program;
using symbolic::Rebuild;
using symbolic::Role;

class ParameterGatherer {
 public:
  explicit ParameterGatherer(const Program& program) : program_(program), rebuild_(graph_, program) {
    for (const symbolic::InputArray& array : program.inputs)
      is_parameter_.insert(is_parameter_.end(), array.elements.size(), array.role == Role::parameters);
  }

  Program run() {
    for (std::size_t i = 0; i < program_.statements.size(); ++i) {
      const symbolic::Statement& s = program_.statements[i];
      if (!is_sum(s.op) && s.op != Op::multiply) {
        rebuild_.keep(i);
        continue;
      }
      rebuild_.enter_section_of(i);
      const Expression a = rebuild_.read(s.a), b = rebuild_.read(s.b);
      rebuild_.set(i, s.op == Op::multiply ? multiply(a, b) : add(a, s.op == Op::add ? b : -b));
    }
    return rebuild_.finish();
  }

 private:
  // An expression as factor * rest, with a known factor.
  struct Product {
    bool has_factor = false;
    Expression factor, rest;
  };

  // Whether the expression depends on parameters and constants alone.
  bool is_known(const Expression& e) {
    if (e.is_constant()) return true;
    const std::vector<Node>& nodes = e.graph()->nodes();
    for (std::size_t i = known_.size(); i < nodes.size(); ++i) {
      const Node& n = nodes[i];
      bool known = n.kind == Node::Kind::constant;
      if (n.kind == Node::Kind::input) known = is_parameter_[static_cast<std::size_t>(n.a)];
      if (n.kind == Node::Kind::operation)
        known = known_[static_cast<std::size_t>(n.a)] && (n.b < 0 || known_[static_cast<std::size_t>(n.b)]);
      known_.push_back(known);
    }
    return known_[static_cast<std::size_t>(e.node())];
  }

  const Node& node(const Expression& e) const { return e.graph()->nodes()[static_cast<std::size_t>(e.node())]; }

  static Expression at(const Expression& e, int node, bool negative) { return e.graph()->expression(node, negative); }

  Product split(const Expression& e) {
    const Node n = node(e);
    if (n.kind == Node::Kind::operation && n.op == Op::multiply) {
      const Expression a = at(e, n.a, false), b = at(e, n.b, false);
      if (is_known(a)) return {true, e.negative() ? -a : a, b};
      if (is_known(b)) return {true, e.negative() ? -b : b, a};
    }
    const Expression one = e.graph()->one();
    return {false, e.negative() ? -one : one, at(e, e.node(), false)};
  }

  Expression multiply(const Expression& a, const Expression& b) {
    if (is_known(a) == is_known(b)) return a * b;
    const Expression& factor = is_known(a) ? a : b;
    const Expression& other = is_known(a) ? b : a;
    const Product product = split(other);
    return product.has_factor ? (factor * product.factor) * product.rest : a * b;
  }

  Expression add(const Expression& a, const Expression& b) {
    if (is_known(a) && is_known(b)) return a + b;
    if (!is_known(a) && !is_known(b)) {
      const Product x = split(a), y = split(b);
      return x.rest == y.rest ? multiply(x.factor + y.factor, x.rest) : a + b;
    }
    const Expression& known = is_known(a) ? a : b;
    const Expression& sum = is_known(a) ? b : a;
    const Node n = node(sum);
    if (n.kind != Node::Kind::operation || !is_sum(n.op)) return a + b;
    const Expression first = at(sum, n.a, sum.negative());
    const Expression second = at(sum, n.b, sum.negative() != (n.op == Op::subtract));
    if (is_known(first)) return second + (first + known);
    return is_known(second) ? first + (second + known) : a + b;
  }

  const Program& program_;
  Graph graph_;
  Rebuild rebuild_;
  std::vector<bool> is_parameter_;  // by input element
  std::vector<bool> known_;         // by node
};

}  // namespace

Program gather_parameters(const Program& program) {
  return ParameterGatherer(program).run();
}

}  // namespace robcogen::pass
