#include "symbolic/expression.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "support/index.h"

namespace robcogen::symbolic {
namespace {

Graph* common_graph(const Expression& a, const Expression& b) {
  if (a.graph() && b.graph() && a.graph() != b.graph()) throw std::logic_error("expressions of two graphs are mixed");
  return a.graph() ? a.graph() : b.graph();
}

}  // namespace

bool Expression::is_constant() const {
  return !graph_ || graph_->nodes()[at(node_)].kind == Node::Kind::constant;
}

Constant Expression::constant() const {
  if (!graph_) return Constant();
  const Constant& c = graph_->constant_of(graph_->nodes()[at(node_)]);
  return negative_ ? -c : c;
}

Expression operator+(const Expression& a, const Expression& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  return common_graph(a, b)->add(a, b);
}

Expression operator*(const Expression& a, const Expression& b) {
  if (a.is_zero()) return a;
  if (b.is_zero()) return b;
  return common_graph(a, b)->multiply(a, b);
}

Expression operator*(double a, const Expression& b) {
  return b.is_zero() ? b : b.graph()->constant(a) * b;
}

Expression operator/(const Expression& a, const Expression& b) {
  if (b.is_zero()) throw std::logic_error("division by the constant zero");
  if (a.is_zero() || b.is_one()) return a;
  if ((-b).is_one()) return -a;
  Graph& g = *common_graph(a, b);
  if (a.is_constant() && b.is_constant()) return g.constant(a.constant() / b.constant());
  const Expression quotient = g.operation(Op::divide, g.positive(a.node()), g.positive(b.node()));
  return a.negative() != b.negative() ? -quotient : quotient;
}

Expression sqrt(const Expression& a) {
  if (a.is_zero()) return a;
  Graph& g = *a.graph();
  // The root of a negative constant is not folded: the program computes it, and yields NaN.
  if (a.is_constant() && a.number().value() > 0) return g.constant(sqrt(a.number()));
  return g.operation(Op::square_root, a, Expression());
}

Expression sin(const Expression& a) {
  if (a.is_zero()) return a;
  Graph& g = *a.graph();
  if (a.is_constant()) return g.constant(sin(a.number()));
  if (const auto known = g.known_sine_cosine(a)) return (*known)[0];
  const Expression s = g.operation(Op::sine, g.positive(a.node()), Expression());
  return a.negative() ? -s : s;
}

Expression cos(const Expression& a) {
  if (!a.graph()) throw std::logic_error("cos of a constant that belongs to no graph");
  Graph& g = *a.graph();
  if (a.is_constant()) return g.constant(cos(a.number()));
  if (const auto known = g.known_sine_cosine(a)) return (*known)[1];
  return g.operation(Op::cosine, g.positive(a.node()), Expression());
}

Expression atan2(const Expression& sine, const Expression& cosine) {
  if (cosine.is_zero()) throw std::logic_error("an arc tangent without a graph, or of a right angle");
  if (sine.is_constant() && cosine.is_constant())
    return cosine.graph()->constant(std::atan2(sine.number().value(), cosine.number().value()));
  Graph& g = *common_graph(sine, cosine);
  const Expression angle = g.operation(Op::arc_tangent, g.positive(sine.node()), cosine);
  return sine.negative() ? -angle : angle;
}

// ---------------------------------------------------------------------------------------------------------------------
// Graph: folding

inline Graph::Scaled Graph::split_factor(int node) const {
  const Node& n = nodes_[at(node)];
  if (is_product(n)) {
    if (is_constant(n.a)) return {n.a, n.b};
    if (is_constant(n.b)) return {n.b, n.a};
  }
  return {1, node};
}

Constant Graph::factor(const Expression& x, const Scaled& split) const {
  const Constant& value = constant_of(nodes_[at(split.factor)]);
  return x.negative() ? -value : value;
}

std::array<Expression, 2> Graph::terms(const Expression& x) {
  const Node& n = node_of(x);
  const Expression first(this, n.a, x.negative()), second(this, n.b, x.negative() != (n.op == Op::subtract));
  return {first, second};
}

std::optional<std::array<Expression, 2>> Graph::known_sine_cosine(const Expression& angle) {
  const Node n = nodes_[at(angle.node())];
  if (n.kind != Node::Kind::operation) return std::nullopt;
  if (n.op == Op::arc_tangent)
    return std::array{Expression(this, n.a, angle.negative()), Expression(this, n.b, n.b_negative)};
  if (!is_sum(n)) return std::nullopt;
  const auto [x, y] = terms(angle);
  if (!known_sine_cosine(x) && !known_sine_cosine(y)) return std::nullopt;
  const Expression sine_x = sin(x), cosine_x = cos(x), sine_y = sin(y), cosine_y = cos(y);
  const Expression first = sine_x * cosine_y, second = cosine_x * sine_y;
  const Expression third = cosine_x * cosine_y, fourth = sine_x * sine_y;
  return std::array{first + second, third - fourth};
}

std::optional<Expression> Graph::folded_sum(const Expression& a, const Expression& b) {
  const bool is_a_sum = is_sum(node_of(a)), is_b_sum = is_sum(node_of(b));
  const auto folded = [&](const Expression& sum, const Expression& other) -> std::optional<Expression> {
    const Node& n = node_of(sum);
    const bool has_constants = is_constant(other.node()) && (is_constant(n.a) || is_constant(n.b));
    if (!has_constants && n.a != other.node() && n.b != other.node()) return std::nullopt;
    const auto [first, second] = terms(sum);
    // (t + c1) + c2
    if (is_constant(other.node())) {
      if (is_constant(first.node())) return second + (first + other);
      if (is_constant(second.node())) return first + (second + other);
    }
    // (p + q) - q
    if (first.node() == other.node() && first.negative() != other.negative()) return second;
    if (second.node() == other.node() && second.negative() != other.negative()) return first;
    return std::nullopt;
  };
  if (is_a_sum)
    if (const auto result = folded(a, b)) return result;
  if (is_b_sum)
    if (const auto result = folded(b, a)) return result;
  if (!is_a_sum || !is_b_sum) return std::nullopt;
  // (p + r) + (q - r)
  const Node &x = node_of(a), &y = node_of(b);
  if (x.a != y.a && x.a != y.b && x.b != y.a && x.b != y.b) return std::nullopt;
  const std::array<Expression, 2> terms_a = terms(a), terms_b = terms(b);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      if (terms_a[i].node() == terms_b[k].node() && terms_a[i].negative() != terms_b[k].negative())
        return terms_a[1 - i] + terms_b[1 - k];
  return std::nullopt;
}

Expression Graph::add(Expression a, Expression b) {
  const Node x = node_of(a), y = node_of(b);
  if (x.kind == Node::Kind::constant && y.kind == Node::Kind::constant) return constant(a.constant() + b.constant());
  if (a.node() == b.node()) {
    static const Constant two = Number(2.0);
    return a.negative() == b.negative() ? constant(two) * a : positive(0);
  }
  // k1 t + k2 t
  if (is_product(x) || is_product(y)) {
    const Scaled split_a = split_factor(a.node()), split_b = split_factor(b.node());
    if (split_a.rest == split_b.rest) return constant(factor(a, split_a) + factor(b, split_b)) * positive(split_a.rest);
  }
  if (is_sum(x) || is_sum(y))
    if (const std::optional<Expression> folded = folded_sum(a, b)) return *folded;
  // Canonical form: the operand that was created first comes first, and a common sign moves outwards.
  if (a.node() > b.node()) std::swap(a, b);
  const Expression sum =
      operation(a.negative() == b.negative() ? Op::add : Op::subtract, positive(a.node()), positive(b.node()));
  return a.negative() ? -sum : sum;
}

Expression Graph::multiply(Expression a, Expression b) {
  const bool is_a_constant = is_constant(a.node()), is_b_constant = is_constant(b.node());
  if (is_a_constant && is_b_constant) return constant(a.constant() * b.constant());
  const bool negative = a.negative() != b.negative();
  if (a.node() == 1) return Expression(this, b.node(), negative);
  if (b.node() == 1) return Expression(this, a.node(), negative);
  // k1 (k2 t)
  if (is_a_constant || is_b_constant) {
    const Expression &scale = is_a_constant ? a : b, &product = is_a_constant ? b : a;
    const Scaled split = split_factor(product.node());
    if (split.rest != product.node()) return constant(scale.constant() * factor(product, split)) * positive(split.rest);
  }
  if (a.node() > b.node()) std::swap(a, b);
  const Expression product = operation(Op::multiply, positive(a.node()), positive(b.node()));
  return negative ? -product : product;
}

}  // namespace robcogen::symbolic
