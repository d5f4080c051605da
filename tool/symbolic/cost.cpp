#include "symbolic/cost.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "support/index.h"
#include "symbolic/blocks.h"
#include "symbolic/fused_products.h"
#include "symbolic/parameter_values.h"

namespace robcogen::symbolic {
namespace {

// How often each operation occurs.
class Operations {
 public:
  void add(Op op) { ++counts_[static_cast<std::size_t>(op)]; }

  // All but sines and cosines, moves and critical path. `fused`: the number of products that are fused into sums.
  Cost cost(int fused) const {
    Cost c;
    c.add = of(Op::add) + of(Op::subtract);
    c.mul = of(Op::multiply);
    c.div = of(Op::divide);
    c.sqrt = of(Op::square_root);
    c.sincos = of(Op::arc_tangent);
    c.instructions = c.mul + c.add - fused;
    return c;
  }

 private:
  std::array<int, static_cast<std::size_t>(Op::sum_lanes) + 1> counts_{};

  int of(Op op) const { return counts_[static_cast<std::size_t>(op)]; }
};

// ---------------------------------------------------------------------------------------------------------------------
// Programs

// The cost of a program whose statements that are `given` cost nothing.
class CostOfProgram {
 public:
  CostOfProgram(const Program& p, std::vector<char> given)
      : p_(p), given_(std::move(given)), is_product_(p.statements.size()) {
    for (std::size_t i = 0; i < p.statements.size(); ++i) is_product_[i] = p.statements[i].op == Op::multiply;
  }

  // All but moves and critical path.
  Cost operations() const {
    Operations counted;
    std::set<std::tuple<int, int, int>> angles;  // kinds, indices and lanes of arguments
    for_each_statement([&](std::size_t, const Statement& s) {
      counted.add(s.op);
      if (s.op == Op::sine || s.op == Op::cosine) angles.emplace(static_cast<int>(s.a.kind), s.a.index, s.a.lane);
    });
    Cost c = counted.cost(fused());
    // The sine of a single lane costs nothing if the sines of all lanes are computed.
    c.sincos += static_cast<int>(std::count_if(angles.begin(), angles.end(), [&](const auto& angle) {
      const auto& [kind, index, lane] = angle;
      return lane < 0 || angles.count({kind, index, -1}) == 0;
    }));
    return c;
  }

  int critical_path() const {
    std::vector<int> ready(p_.statements.size(), 0);
    const auto of = [&](const Operand& o) { return is_statement(o) ? ready[at(o.index)] : 0; };
    for_each_statement([&](std::size_t i, const Statement& s) {
      if (s.op == Op::sine || s.op == Op::cosine) return;
      int start = 0;
      for_each_operand(s, [&](const Operand& o) { start = std::max(start, of(o)); });
      if (s.op == Op::gather && start == 0) return;  // it can be computed ahead
      ready[i] = start + latency(s.op, width_of(p_, s.a));
      if (!is_sum(s.op)) return;
      for (const auto& [product, other] : {std::pair(s.a, s.b), std::pair(s.b, s.a)}) {
        if (!is_product(product) || !is_fusable(s, product)) continue;
        const Statement& inner = p_.statements[at(product.index)];
        ready[i] = std::min(ready[i], std::max({of(inner.a), of(inner.b), of(other)}) + kLatency);
      }
    });
    int longest = 0;
    for (const OutputArray& array : p_.outputs)
      for (const Operand& o : array.values) longest = std::max(longest, of(o));
    return longest;
  }

 private:
  const Program& p_;
  const std::vector<char> given_;
  std::vector<char> is_product_;

  template <class F>
  void for_each_statement(F f) const {
    for (std::size_t i = 0; i < p_.statements.size(); ++i)
      if (!given_[i]) f(i, p_.statements[i]);
  }

  bool is_product(const Operand& o) const {
    return is_statement(o) && is_product_[at(o.index)] && !given_[at(o.index)];
  }

  // Whether a sum can be fused with this product. A scalar product that a sum with lanes reads is computed before it.
  bool is_fusable(const Statement& sum, const Operand& product) const {
    return product.lane < 0 && sum.width == p_.statements[at(product.index)].width;
  }

  int fused() const {
    FusedProducts products(p_.statements.size());
    for (const OutputArray& array : p_.outputs)
      for (const Operand& o : array.values)
        if (is_product(o)) products.add_use(o.index, FusedProducts::kOther);
    for (std::size_t i = p_.statements.size(); i-- > 0;) {
      if (given_[i]) continue;
      const Statement& s = p_.statements[i];
      const auto user = static_cast<int>(i);
      for_each_operand(s, [&](const Operand& o) {
        if (!is_product(o)) return;
        products.add_use(o.index, is_sum(s.op) && is_fusable(s, o) ? user : FusedProducts::kOther);
      });
      if (s.op == Op::multiply) products.add(user);
    }
    return products.count();
  }
};

// The number of instructions that move lanes to outputs. An element that is a lane but in no block costs one.
int moves_to_outputs(const Program& p) {
  int count = 0;
  for (const OutputArray& array : p.outputs)
    count += static_cast<int>(
        std::count_if(array.values.begin(), array.values.end(), [](const Operand& o) { return o.lane >= 0; }));
  for (const Block& block : stores(p).blocks) {
    const auto from_lanes = std::count_if(block.columns.begin(), block.columns.end(), is_statement);
    count += moves(block) - block.width * static_cast<int>(from_lanes);
  }
  return count;
}

// The number of instructions that gather scalars into lanes and extract them.
int moves(const Program& p) {
  int count = 0;
  std::vector<bool> is_loaded(p.statements.size(), false);
  for (const Block& block : loads(p)) {
    count += moves(block);
    for (const Operand& o : block.columns) is_loaded[at(o.index)] = true;
  }
  std::set<std::pair<int, int>> picked;
  const auto note = [&](const Operand& o) {
    if (is_statement(o) && o.lane > 0) picked.emplace(o.index, o.lane);
  };
  for (std::size_t i = 0; i < p.statements.size(); ++i) {
    const Statement& s = p.statements[i];
    if (s.op == Op::gather && !is_loaded[i] && !std::all_of(s.lanes.begin(), s.lanes.end(), is_constant))
      count += s.width - 1;
    for_each_operand(s, note);
    if (s.op == Op::sum_lanes)
      for (int width = width_of(p, s.a); width > 1; width /= 2) count += 2;
  }
  return count + static_cast<int>(picked.size()) + moves_to_outputs(p);
}

Cost cost(const Program& p, std::vector<char> given) {
  const CostOfProgram of(p, std::move(given));
  Cost c = of.operations();
  if (p.has_lanes()) c.moves = moves(p);
  c.critical_path = of.critical_path();
  return c;
}

// ---------------------------------------------------------------------------------------------------------------------
// Graphs

bool is_product(const Node& n) {
  return n.kind == Node::Kind::operation && n.op == Op::multiply;
}

}  // namespace

Cost cost(const Program& program) {
  return cost(program, std::vector<char>(program.statements.size(), false));
}

int predicted_time(const Program& program) {
  // Values that depend on parameters alone were split off before congruent limbs went into lanes.
  return time(program.has_lanes() ? cost(program) : cost(program, follow_from_parameters(program)));
}

int work(const Program& program) {
  return weighted(CostOfProgram(program, follow_from_parameters(program)).operations(), kWork);
}

TracedCost traced_cost(const Graph& graph, const std::vector<std::vector<Expression>>& outputs) {
  const std::vector<Node>& nodes = graph.nodes();
  std::vector<char> needed(nodes.size(), false);
  FusedProducts products(nodes.size());
  const auto note = [&](int node, int user) {
    needed[at(node)] = true;
    if (is_product(nodes[at(node)])) products.add_use(node, user);
  };
  for (const std::vector<Expression>& values : outputs)
    for (const Expression& e : values) note(e.node(), FusedProducts::kOther);
  TracedCost result;
  Operations counted;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!needed[i]) continue;
    const Node& n = nodes[i];
    if (n.kind == Node::Kind::constant)
      result.largest_constant = std::max(result.largest_constant, graph.constant_of(n).value());
    if (n.kind != Node::Kind::operation) continue;
    ++result.statements;
    counted.add(n.op);
    if (n.op == Op::multiply) products.add(static_cast<int>(i));
    const int user = is_sum(n.op) ? static_cast<int>(i) : FusedProducts::kOther;
    note(n.a, user);
    if (n.b >= 0) note(n.b, user);
  }
  result.work = weighted(counted.cost(products.count()), kWork);
  return result;
}

int work_since(const Graph& graph, std::size_t mark) {
  const std::vector<Node>& nodes = graph.nodes();
  Operations counted;
  int fused = 0;
  for (std::size_t i = mark; i < nodes.size(); ++i) {
    const Node& n = nodes[i];
    if (n.kind != Node::Kind::operation) continue;
    counted.add(n.op);
    if (is_sum(n.op) && (is_product(nodes[at(n.a)]) || is_product(nodes[at(n.b)]))) ++fused;
  }
  return weighted(counted.cost(fused), kWork);
}

}  // namespace robcogen::symbolic
