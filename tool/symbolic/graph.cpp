// The nodes of a graph, their quantities, and the program that computes some of them.
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "support/index.h"
#include "symbolic/expression.h"

namespace robcogen::symbolic {
namespace {

// The sizes of the hash table of a new graph, and of a table that becomes too small, by that of the old one.
constexpr std::size_t kFirstSlots = 128, kGrowth = 4;

}  // namespace

Graph::Graph() : known_(kFirstSlots) {
  sections_.push_back({"", "t"});
  section_starts_.push_back(0);
  constant(0.0);
  constant(1.0);
}

inline std::uint32_t Graph::hash(const Node& n) const {
  std::uint64_t h = 0;
  if (n.kind == Node::Kind::constant) {
    h = std::bit_cast<std::uint64_t>(constant_of(n).value());
  } else {
    const std::uint64_t a = static_cast<std::uint32_t>(n.a), b = static_cast<std::uint32_t>(n.b);
    h = (a << 32 | b) +
        (static_cast<std::uint64_t>(n.op) + (n.kind == Node::Kind::input ? 16 : 0)) * 0x9fb21c651e98df25ULL;
  }
  h *= 0x9e3779b97f4a7c15ULL;
  h = (h ^ h >> 32) * 0x94d049bb133111ebULL;
  return static_cast<std::uint32_t>(h >> 32);
}

bool Graph::are_same_constants(const Node& m, const Node& n) const {
  if (m.kind != Node::Kind::constant) return false;
  const Constant &a = constant_of(m), &b = constant_of(n);
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return bits(a.value()) == bits(b.value()) && bits(a.representative()) == bits(b.representative()) &&
         a.number().is_pi_multiple() == b.number().is_pi_multiple();
}

inline bool Graph::is_same(const Node& m, const Node& n) const {
  return n.kind == Node::Kind::constant ? are_same_constants(m, n) : m == n;
}

inline std::size_t Graph::slot(const Node& n, std::uint32_t hash) const {
  const std::size_t mask = known_.size() - 1;
  std::size_t place = hash & mask;
  while (known_[place].node >= 0 && (known_[place].hash != hash || !is_same(nodes_[at(known_[place].node)], n)))
    place = (place + 1) & mask;
  return place;
}

void Graph::reserve(std::size_t nodes) {
  nodes_.reserve(nodes);
  if (2 * nodes > known_.size()) resize_table(std::bit_ceil(2 * nodes));
}

// The nodes are inserted in the order of their creation again.
void Graph::resize_table(std::size_t size) {
  std::vector<std::uint32_t> hashes(nodes_.size());
  for (const KnownNode& known : known_)
    if (known.node >= 0) hashes[at(known.node)] = known.hash;
  known_.assign(size, {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    std::size_t place = hashes[i] & (known_.size() - 1);
    while (known_[place].node >= 0) place = (place + 1) & (known_.size() - 1);
    known_[place] = {hashes[i], static_cast<int>(i)};
  }
}

int Graph::intern(const Node& n) {
  if (2 * (nodes_.size() + 1) > known_.size()) resize_table(kGrowth * known_.size());
  const std::uint32_t own = hash(n);
  KnownNode& known = known_[slot(n, own)];
  if (known.node >= 0) return known.node;
  const auto node = static_cast<int>(nodes_.size());
  known = {own, node};
  nodes_.push_back(n);
  return node;
}

Expression Graph::constant(const Constant& value) {
  if (std::isnan(value.value()) || std::isinf(value.value())) throw std::logic_error("a constant is not finite");
  const bool negative = value.value() < 0 || (value.value() == 0.0 && value.representative() < 0);
  const Constant magnitude = value.is_zero() ? Constant() : negative ? -value : value;
  const std::size_t constants_before = constants_.size();
  constants_.push_back(magnitude);
  Node n;
  n.a = static_cast<int>(constants_before);
  const int node = intern(n);
  if (nodes_[at(node)].a != n.a) constants_.pop_back();  // the constant exists already
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
    const Node& last = nodes_.back();
    known_[slot(last, hash(last))] = {};
    nodes_.pop_back();
  }
  quantities_.resize(std::min(quantities_.size(), mark));
  for (std::size_t s = section_starts_.size(); s-- > 0 && section_starts_[s] > mark;) section_starts_[s] = mark;
}

void Graph::begin_section(std::string title, std::string prefix) {
  if (!names_matter_) return;
  sections_.push_back({std::move(title), std::move(prefix)});
  section_starts_.push_back(nodes_.size());
}

bool Graph::takes_quantity(const Expression& e, bool is_own) const {
  if (!e.graph() || !names_matter_) return false;
  const auto node = at(e.node());
  if (nodes_[node].kind != Node::Kind::operation) return false;
  if (node >= quantities_.size()) return true;
  const NodeQuantity& known = quantities_[node];
  return !known.is_own && (is_own || !known.quantity);
}

void Graph::set_quantity(const Expression& e, Quantity quantity, bool is_own) {
  if (!takes_quantity(e, is_own)) return;
  quantity.negative = quantity.negative != e.negative();
  if (quantities_.size() <= at(e.node())) quantities_.resize(at(e.node()) + 1);
  quantities_[at(e.node())] = {std::make_shared<const Quantity>(std::move(quantity)), is_own};
}

void Graph::name(const Expression& e, const Statement& s) {
  if (!s.quantity || !takes_quantity(e, s.named)) return;
  if (e.negative()) return set_quantity(e, *s.quantity, s.named);
  if (quantities_.size() <= at(e.node())) quantities_.resize(at(e.node()) + 1);
  quantities_[at(e.node())] = {s.quantity, s.named};
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
// The program

Program Graph::program(
    std::string name,
    std::vector<InputArray> inputs,
    std::vector<OutputArray> shapes,
    const std::vector<std::vector<Expression>>& outputs) const {
  std::vector<char> reachable(nodes_.size(), false);
  for (const auto& values : outputs)
    for (const Expression& e : values) reachable[at(e.node())] = true;
  std::size_t operations = 0;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& n = nodes_[i];
    if (!reachable[i] || n.kind != Node::Kind::operation) continue;
    ++operations;
    reachable[at(n.a)] = true;
    if (n.b >= 0) reachable[at(n.b)] = true;
  }

  Program p;
  p.name = std::move(name);
  p.inputs = std::move(inputs);
  p.outputs = std::move(shapes);

  std::vector<int> new_section(sections_.size(), -1);
  std::vector<Operand> operand_of(nodes_.size());
  p.statements.reserve(operations);
  std::size_t section = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    while (section + 1 < sections_.size() && section_starts_[section + 1] <= i) ++section;
    if (!reachable[i]) continue;
    const Node& n = nodes_[i];
    Operand& here = operand_of[i];
    if (n.kind == Node::Kind::constant) {
      here = {Operand::Kind::constant, static_cast<int>(p.constants.size()), false};
      p.constants.push_back(constant_of(n));
    } else if (n.kind == Node::Kind::input) {
      here = {Operand::Kind::input, n.a, false};
    } else {
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
      if (i < quantities_.size()) {
        s.quantity = quantities_[i].quantity;
        s.named = quantities_[i].is_own;
      }
    }
  }
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    OutputArray& array = p.outputs[k];
    if (outputs[k].size() != at(array.rows * array.columns))
      throw std::logic_error("output '" + array.name + "' has the wrong number of values");
    array.values.reserve(outputs[k].size());
    for (const Expression& e : outputs[k]) {
      Operand value = operand_of[at(e.node())];
      value.negative = e.negative();
      array.values.push_back(value);
    }
  }
  return p;
}

}  // namespace robcogen::symbolic
