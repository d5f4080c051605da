#include "symbolic/partials.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "support/index.h"
#include "symbolic/derivative.h"

namespace robcogen::symbolic {

Partials partials(Graph& graph, std::size_t i) {
  const Node node = graph.nodes()[i];
  const Expression value = graph.expression(static_cast<int>(i), false);
  const Expression a = graph.expression(node.a, false);
  const Expression b = node.b < 0 ? Expression() : graph.expression(node.b, false);
  const Expression one = graph.one();
  switch (node.op) {
    case Op::add:
      return {one, [one] { return one; }};
    case Op::subtract:
      return {one, [one] { return -one; }};
    case Op::multiply:
      return {b, [a] { return a; }};
    case Op::divide: {
      const Expression reciprocal = one / b;
      return {reciprocal, [value, reciprocal] { return -(value * reciprocal); }};
    }
    case Op::square_root: {
      const Expression half = 0.5 * (one / value);
      return {node.a_negative ? -half : half, {}};
    }
    case Op::sine:
      return {cos(a), {}};
    case Op::cosine:
      return {-sin(a), {}};
    case Op::arc_tangent: {  // of a sine and a cosine, whose squares add up to one
      const Expression cosine = node.b_negative ? -b : b;
      return {cosine, [a, is_negative = node.b_negative] { return is_negative ? a : -a; }};
    }
    default:
      throw std::logic_error("derivative of an operation on lanes");
  }
}

Expression derivative(const Expression& of, const Expression& by) {
  if (!of.graph() || of.is_constant()) return {};
  Graph& graph = *of.graph();
  const Node node = graph.nodes()[at(of.node())];
  if (of.node() == by.node()) return of.negative() ? -graph.one() : graph.one();
  if (node.kind != Node::Kind::operation) return {};
  const Partials p = partials(graph, at(of.node()));
  Expression result = p.a * derivative(graph.expression(node.a, false), by);
  if (node.b >= 0) result += p.b() * derivative(graph.expression(node.b, false), by);
  return of.negative() ? -result : result;
}

namespace {

// By node, up to the last of these expressions: whether one of them depends on it without passing a given one.
std::vector<bool> needed_nodes(
    const Graph& graph,
    const std::vector<Expression>& of,
    const std::vector<bool>& is_given) {
  std::vector<bool> needed(is_given.size());
  for (const Expression& e : of)
    if (e.graph()) needed[at(e.node())] = true;
  for (std::size_t i = needed.size(); i-- > 0;) {
    const Node& node = graph.nodes()[i];
    if (!needed[i] || is_given[i] || node.kind != Node::Kind::operation) continue;
    needed[at(node.a)] = true;
    if (node.b >= 0) needed[at(node.b)] = true;
  }
  return needed;
}

}  // namespace

std::vector<Expression> rates_of(const std::vector<Expression>& of, const std::vector<Rate>& changes) {
  Graph* graph = nullptr;
  int last = -1;
  for (const Expression& e : of)
    if (e.graph()) graph = e.graph(), last = std::max(last, e.node());
  std::vector<Expression> result(of.size());
  if (!graph) return result;
  const std::size_t size = at(last) + 1;
  std::vector<Expression> rate(size);
  std::vector<bool> is_given(size);
  for (const Rate& change : changes) {
    if (!change.of.graph() || change.of.is_constant() || change.of.node() > last) continue;
    rate[at(change.of.node())] = change.of.negative() ? -change.rate : change.rate;
    is_given[at(change.of.node())] = true;
  }
  const std::vector<bool> needed = needed_nodes(*graph, of, is_given);
  for (std::size_t i = 0; i < size; ++i) {
    const Node node = graph->nodes()[i];
    if (!needed[i] || is_given[i] || node.kind != Node::Kind::operation) continue;
    const Expression &a = rate[at(node.a)], b = node.b < 0 ? Expression() : rate[at(node.b)];
    if (a.is_zero() && b.is_zero()) continue;
    const Partials p = partials(*graph, i);
    if (!a.is_zero()) rate[i] = p.a * a;
    if (!b.is_zero()) rate[i] += p.b() * b;
  }
  for (std::size_t k = 0; k < of.size(); ++k)
    if (of[k].graph()) result[k] = of[k].negative() ? -rate[at(of[k].node())] : rate[at(of[k].node())];
  return result;
}

}  // namespace robcogen::symbolic
