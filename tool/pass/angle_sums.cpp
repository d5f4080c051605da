#include "pass/angle_sums.h"

#include "support/index.h"
#include "symbolic/apply.h"

namespace robcogen::pass {

using symbolic::Expression;
using symbolic::Graph;
using symbolic::Node;
using symbolic::Op;

bool AngleSums::reads_slide(const Expression& e) const {
  const Node& n = node(e);
  if (n.kind == Node::Kind::input) return n.a >= parameter_count_ && !positions_[at(n.a - parameter_count_)].is_angle;
  return n.kind == Node::Kind::operation && (reads_slide(operand(n.a)) || (n.b >= 0 && reads_slide(operand(n.b))));
}

bool AngleSums::follows_from_parameters(const Expression& e) const {
  const Node& n = node(e);
  if (n.kind == Node::Kind::input) return n.a < parameter_count_;
  if (n.kind == Node::Kind::constant) return true;
  return follows_from_parameters(operand(n.a)) && (n.b < 0 || follows_from_parameters(operand(n.b)));
}

std::optional<SinCos> AngleSums::by_addition(Graph& graph, const Expression& e) const {
  if (follows_from_parameters(e)) {
    const Expression angle = copy(graph, e);
    return SinCos{sin(angle), cos(angle)};
  }
  const Node& n = node(e);
  std::optional<SinCos> result;
  if (n.kind == Node::Kind::input) result = SinCos{graph.input(n.a), graph.input(n.a + joint_count())};
  if (n.kind == Node::Kind::operation && (n.op == Op::add || n.op == Op::subtract)) {
    const std::optional<SinCos> a = by_addition(graph, operand(n.a));
    std::optional<SinCos> b = by_addition(graph, operand(n.b));
    if (!a || !b) return std::nullopt;
    if (n.op == Op::subtract) b->sin = -b->sin;
    const Expression sc = a->sin * b->cos, cc = a->cos * b->cos;
    result = SinCos{sc + a->cos * b->sin, cc - a->sin * b->sin};
  }
  if (result && e.negative()) result->sin = -result->sin;
  return result;
}

std::string AngleSums::label(const Expression& e) const {
  std::string joints;
  bool turned = false;
  describe(e, joints, turned);
  return turned ? joints + "_turned" : joints;
}

const Node& AngleSums::node(const Expression& e) const {
  return graph_.nodes()[at(e.node())];
}

Expression AngleSums::operand(int node) const {
  return const_cast<Graph&>(graph_).expression(node, false);
}

// Copies an expression that depends on parameters alone to another graph with the same parameters.
Expression AngleSums::copy(Graph& graph, const Expression& e) const {
  const Node& n = node(e);
  Expression result;
  if (n.kind == Node::Kind::input) result = graph.input(n.a);
  if (n.kind == Node::Kind::constant) result = graph.constant(graph_.constant_of(n));
  if (n.kind == Node::Kind::operation) {
    const Expression a = copy(graph, operand(n.a)), b = n.b < 0 ? Expression() : copy(graph, operand(n.b));
    result = symbolic::apply(n.op, n.a_negative ? -a : a, b);
  }
  return e.negative() ? -result : result;
}

void AngleSums::describe(const Expression& e, std::string& joints, bool& turned) const {
  const Node& n = node(e);
  if (follows_from_parameters(e)) {
    turned = true;
  } else if (n.kind == Node::Kind::input) {
    joints += (joints.empty() ? "" : "_") + positions_[at(n.a - parameter_count_)].joint;
  } else {
    describe(operand(n.a), joints, turned);
    describe(operand(n.b), joints, turned);
  }
}

}  // namespace robcogen::pass
