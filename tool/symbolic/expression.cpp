#include "symbolic/expression.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "support/index.h"
#include "support/unique_names.h"

namespace robcogen::symbolic {
namespace {

Graph* common_graph(const Expression& a, const Expression& b) {
  if (a.graph() && b.graph() && a.graph() != b.graph()) throw std::logic_error("expressions of two graphs are mixed");
  return a.graph() ? a.graph() : b.graph();
}

// Makes the names that statements have unique, and numbers the others by their sections' prefixes.
void name_statements(Program& p) {
  UniqueNames used;
  for (const bool is_own : {true, false})
    for (Statement& s : p.statements)
      if (has_meaning(s) && s.named == is_own) s.name = used.add(s.name);
  // Two numbered names are different anyway.
  std::unordered_map<std::string, int> next_number;
  std::vector<int*> next_of_section;
  for (const Section& section : p.sections) next_of_section.push_back(&next_number[section.prefix]);
  for (Statement& s : p.statements) {
    if (has_meaning(s)) continue;
    const auto section = at(s.section);
    s.name = p.sections[section].prefix + "_t" + std::to_string((*next_of_section[section])++);
    if (used.contains(s.name)) s.name = used.add(s.name);
  }
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------------------
// Expression

bool Expression::is_constant() const {
  return !graph_ || graph_->nodes()[at(node_)].kind == Node::Kind::constant;
}

Number Expression::number() const {
  if (!graph_) return Number();
  const Number& n = graph_->number(graph_->nodes()[at(node_)]);
  return negative_ ? -n : n;
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
  if (a.is_constant() && b.is_constant()) return g.constant(a.number() / b.number());
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
// Graph: nodes

Graph::Graph() : known_(1024) {
  sections_.push_back({"", "t"});
  constant(0.0);
  constant(1.0);
}

std::uint32_t Graph::hash(const Key& k) {
  std::uint64_t h = k.bits * 0x9e3779b97f4a7c15ULL ^ (k.kind + 0x7f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
  h ^= h >> 29;
  h *= 0x94d049bb133111ebULL;
  return static_cast<std::uint32_t>(h ^ (h >> 32));
}

std::size_t Graph::slot(const Key& k, std::uint32_t hash) const {
  const auto is_other = [&](const KnownNode& known) {
    return known.node >= 0 && (known.hash != hash || !(key(nodes_[at(known.node)]) == k));
  };
  std::size_t place = hash & (known_.size() - 1);
  while (is_other(known_[place])) place = (place + 1) & (known_.size() - 1);
  return place;
}

// The nodes stand in the order of their making again.
void Graph::grow() {
  std::vector<std::uint32_t> hashes(nodes_.size());
  for (const KnownNode& known : known_)
    if (known.node >= 0) hashes[at(known.node)] = known.hash;
  known_.assign(2 * known_.size(), {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    std::size_t place = hashes[i] & (known_.size() - 1);
    while (known_[place].node >= 0) place = (place + 1) & (known_.size() - 1);
    known_[place] = {hashes[i], static_cast<int>(i)};
  }
}

Graph::Key Graph::key(const Node& n) const {
  const auto kind = static_cast<std::uint64_t>(n.kind);
  if (n.kind == Node::Kind::constant) {
    const Number& value = number(n);
    return {
        std::bit_cast<std::uint64_t>(value.value()), kind * 64 + (value.is_pi_multiple() ? 1 : 0),
        std::bit_cast<std::uint64_t>(value.typical())};
  }
  const std::uint64_t a = static_cast<std::uint32_t>(n.a);
  const std::uint64_t b = static_cast<std::uint32_t>(n.b);
  return {
      a << 32 | b, kind * 64 + static_cast<std::uint64_t>(n.op) * 2 + (n.a_negative ? 1 : 0) + (n.b_negative ? 32 : 0)};
}

int Graph::intern(const Node& n) {
  const Key wanted = key(n);
  const std::uint32_t own = hash(wanted);
  std::size_t place = slot(wanted, own);
  if (known_[place].node >= 0) return known_[place].node;
  if (2 * (nodes_.size() + 1) > known_.size()) {
    grow();
    place = slot(wanted, own);
  }
  known_[place] = {own, static_cast<int>(nodes_.size())};
  nodes_.push_back(n);
  section_of_.push_back(static_cast<int>(sections_.size()) - 1);
  return known_[place].node;
}

Expression Graph::constant(const Number& value) {
  if (std::isnan(value.value()) || std::isinf(value.value())) throw std::logic_error("a constant is not finite");
  const bool negative = value.value() < 0 || (value.value() == 0.0 && value.typical() < 0);
  const Number magnitude = value.is_zero() ? Number() : negative ? -value : value;
  const std::size_t constants_before = constants_.size();
  constants_.push_back(magnitude);
  Node n;
  n.a = static_cast<int>(constants_before);
  const int node = intern(n);
  if (nodes_[at(node)].a != n.a) constants_.pop_back();  // it was known
  return Expression(this, node, negative);
}

Expression Graph::input(int element) {
  Node n;
  n.kind = Node::Kind::input;
  n.a = element;
  return positive(intern(n));
}

void Graph::rollback(std::size_t mark) {
  while (nodes_.size() > mark) {
    const Key last = key(nodes_.back());
    known_[slot(last, hash(last))] = {};
    nodes_.pop_back();
    section_of_.pop_back();
  }
  names_.resize(std::min(names_.size(), mark));
}

int Graph::cost_since(std::size_t mark) const {
  constexpr int kDivision = 8;
  const auto is_product = [&](int node) {
    const Node& n = nodes_[at(node)];
    return n.kind == Node::Kind::operation && n.op == Op::multiply;
  };
  int cost = 0;
  for (std::size_t i = mark; i < nodes_.size(); ++i) {
    const Node& n = nodes_[i];
    if (n.kind != Node::Kind::operation) continue;
    const bool sum = n.op == Op::add || n.op == Op::subtract;
    const bool swallows = sum && (is_product(n.a) || is_product(n.b));
    cost += n.op == Op::divide || n.op == Op::square_root ? kDivision : swallows ? 1 : is_binary(n.op) ? 2 : 0;
  }
  return cost;
}

void Graph::begin_section(std::string title, std::string prefix) {
  if (names_matter_) sections_.push_back({std::move(title), std::move(prefix)});
}

void Graph::name(const Expression& e, const std::string& name) {
  set_name(e, name, true);
}

void Graph::describe(const Expression& e, const std::string& name) {
  set_name(e, name, false);
}

void Graph::set_name(const Expression& e, const std::string& name, bool is_own) {
  if (!e.graph() || !names_matter_) return;
  const auto node = at(e.node());
  if (nodes_[node].kind != Node::Kind::operation) return;
  if (names_.size() <= node) names_.resize(node + 1);
  NodeName& known = names_[node];
  if (known.is_own || (!is_own && !known.text.empty())) return;
  known.is_own = is_own;
  // The node holds the value without its sign.
  if (!e.negative())
    known.text = name;
  else
    known.text = name.ends_with("_neg") ? name.substr(0, name.size() - 4) : name + "_neg";
}

Expression Graph::operation(Op op, const Expression& a, const Expression& b) {
  Node n;
  n.kind = Node::Kind::operation;
  n.op = op;
  n.a = a.node();
  n.b = is_binary(op) ? b.node() : -1;
  n.a_negative = op == Op::square_root && a.negative();
  n.b_negative = op == Op::arc_tangent && b.negative();
  return positive(intern(n));
}

// ---------------------------------------------------------------------------------------------------------------------
// Graph: folding

Graph::Scaled Graph::split_factor(int node) const {
  const Node& n = nodes_[at(node)];
  if (n.kind == Node::Kind::operation && n.op == Op::multiply) {
    if (is_constant(n.a)) return {n.a, n.b};
    if (is_constant(n.b)) return {n.b, n.a};
  }
  return {1, node};
}

Number Graph::factor(const Expression& x, const Scaled& split) const {
  const Number& value = number(nodes_[at(split.factor)]);
  return x.negative() ? -value : value;
}

std::optional<std::array<Expression, 2>> Graph::terms(const Expression& x) {
  const Node n = nodes_[at(x.node())];
  if (n.kind != Node::Kind::operation || (n.op != Op::add && n.op != Op::subtract)) return std::nullopt;
  const Expression first(this, n.a, x.negative()), second(this, n.b, x.negative() != (n.op == Op::subtract));
  return std::array{first, second};
}

std::optional<std::array<Expression, 2>> Graph::known_sine_cosine(const Expression& angle) {
  const Node n = nodes_[at(angle.node())];
  if (n.kind != Node::Kind::operation) return std::nullopt;
  if (n.op == Op::arc_tangent)
    return std::array{Expression(this, n.a, angle.negative()), Expression(this, n.b, n.b_negative)};
  const std::optional<std::array<Expression, 2>> both = terms(angle);
  if (!both) return std::nullopt;
  const auto& [x, y] = *both;
  if (!known_sine_cosine(x) && !known_sine_cosine(y)) return std::nullopt;
  const Expression sine_x = sin(x), cosine_x = cos(x), sine_y = sin(y), cosine_y = cos(y);
  const Expression first = sine_x * cosine_y, second = cosine_x * sine_y;
  const Expression third = cosine_x * cosine_y, fourth = sine_x * sine_y;
  return std::array{first + second, third - fourth};
}

Expression Graph::add(Expression a, Expression b) {
  if (a.is_constant() && b.is_constant()) return constant(a.number() + b.number());
  if (a.node() == b.node()) {
    if (a.negative() != b.negative()) return positive(0);
    return constant(2.0) * a;
  }
  // k1 t + k2 t
  const Scaled split_a = split_factor(a.node()), split_b = split_factor(b.node());
  if (split_a.rest == split_b.rest) return constant(factor(a, split_a) + factor(b, split_b)) * positive(split_a.rest);
  for (const auto& [sum, other] : {std::pair(a, b), std::pair(b, a)}) {
    const std::optional<std::array<Expression, 2>> both = terms(sum);
    if (!both) continue;
    const auto& [first, second] = *both;
    // (t + c1) + c2
    if (other.is_constant() && first.is_constant()) return second + (first + other);
    if (other.is_constant() && second.is_constant()) return first + (second + other);
    // (p + q) - q
    if (first.node() == other.node() && first.negative() != other.negative()) return second;
    if (second.node() == other.node() && second.negative() != other.negative()) return first;
  }
  // (p + r) + (q - r)
  const std::optional<std::array<Expression, 2>> terms_a = terms(a), terms_b = terms(b);
  if (terms_a && terms_b)
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k)
        if ((*terms_a)[i] == -(*terms_b)[k]) return (*terms_a)[1 - i] + (*terms_b)[1 - k];
  // Canonical form: the operand that was made first stands first; a common sign moves outwards.
  const bool ordered = a.node() < b.node();
  if (!ordered) std::swap(a, b);
  const Expression sum =
      operation(a.negative() == b.negative() ? Op::add : Op::subtract, positive(a.node()), positive(b.node()));
  return a.negative() ? -sum : sum;
}

Expression Graph::multiply(Expression a, Expression b) {
  if (a.is_constant() && b.is_constant()) return constant(a.number() * b.number());
  const bool negative = a.negative() != b.negative();
  if (a.node() == 1) return Expression(this, b.node(), negative);
  if (b.node() == 1) return Expression(this, a.node(), negative);
  // k1 (k2 t)
  for (const auto& [scale, product] : {std::pair(a, b), std::pair(b, a)}) {
    if (!scale.is_constant()) continue;
    const Scaled split = split_factor(product.node());
    if (split.rest != product.node()) return constant(scale.number() * factor(product, split)) * positive(split.rest);
  }
  if (a.node() > b.node()) std::swap(a, b);
  const Expression product = operation(Op::multiply, positive(a.node()), positive(b.node()));
  return negative ? -product : product;
}

// ---------------------------------------------------------------------------------------------------------------------
// Graph: the program

Program Graph::program(
    std::string name,
    std::vector<InputArray> inputs,
    std::vector<OutputArray> shapes,
    const std::vector<std::vector<Expression>>& outputs) const {
  std::vector<bool> reachable(nodes_.size(), false);
  for (const auto& values : outputs)
    for (const Expression& e : values) reachable[at(e.node())] = true;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    if (!reachable[i] || nodes_[i].kind != Node::Kind::operation) continue;
    reachable[at(nodes_[i].a)] = true;
    if (nodes_[i].b >= 0) reachable[at(nodes_[i].b)] = true;
  }

  Program p;
  p.name = std::move(name);
  p.inputs = std::move(inputs);
  p.outputs = std::move(shapes);

  std::vector<int> new_section(sections_.size(), -1);
  std::vector<Operand> operand_of(nodes_.size());
  p.statements.reserve(static_cast<std::size_t>(std::count(reachable.begin(), reachable.end(), true)));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!reachable[i]) continue;
    const Node& n = nodes_[i];
    Operand& here = operand_of[i];
    if (n.kind == Node::Kind::constant) {
      here = {Operand::Kind::constant, static_cast<int>(p.constants.size()), false};
      p.constants.push_back(number(n));
    } else if (n.kind == Node::Kind::input) {
      here = {Operand::Kind::input, n.a, false};
    } else {
      const auto section = at(section_of_[i]);
      if (new_section[section] < 0) {
        new_section[section] = static_cast<int>(p.sections.size());
        p.sections.push_back(sections_[section]);
      }
      here = {Operand::Kind::statement, static_cast<int>(p.statements.size()), false};
      Statement& s = p.statements.emplace_back();
      s.op = n.op;
      s.a = operand_of[at(n.a)];
      s.a.negative = n.a_negative;
      if (n.b >= 0) s.b = operand_of[at(n.b)];
      s.b.negative = s.b.negative != n.b_negative;
      s.section = new_section[section];
      if (i < names_.size()) {
        s.name = names_[i].text;
        s.named = names_[i].is_own;
        s.described = !s.named && !s.name.empty();
      }
    }
  }
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    OutputArray& array = p.outputs[k];
    if (outputs[k].size() != at(array.rows * array.columns))
      throw std::logic_error("output '" + array.name + "' has the wrong number of values");
    for (const Expression& e : outputs[k]) {
      Operand value = operand_of[at(e.node())];
      value.negative = e.negative();
      array.values.push_back(value);
    }
  }
  if (names_matter_) name_statements(p);
  return p;
}

}  // namespace robcogen::symbolic
