#include "symbolic/cost.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "support/index.h"
#include "symbolic/blocks.h"
#include "symbolic/fused_products.h"
#include "symbolic/parameter_values.h"

namespace robcogen::symbolic {
namespace {

void count_operation(Cost& c, Op op) {
  switch (op) {
    case Op::add:
    case Op::subtract:
      ++c.add;
      break;
    case Op::multiply:
      ++c.mul;
      break;
    case Op::divide:
      ++c.div;
      break;
    case Op::square_root:
      ++c.sqrt;
      break;
    case Op::arc_tangent:
      ++c.sincos;
      break;
    case Op::sine:
    case Op::cosine:
    case Op::gather:
    case Op::sum_lanes:
      break;
  }
}

// The number of products that are fused into sums. `for_each_use(note)` calls note(product, user) for each use of a
// product, in the order of the users; -1 stands for a user that cannot be fused with it.
template <class ForEachUse>
int fused(std::size_t size, const ForEachUse& for_each_use) {
  std::vector<int> first(size + 1, 0);
  for_each_use([&](int product, int) { ++first[at(product) + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> users(at(first.back())), next = first;
  for_each_use([&](int product, int user) { users[at(next[at(product)]++)] = user; });
  std::vector<std::span<const int>> products;
  for (std::size_t i = 0; i < size; ++i) {
    const std::span<const int> own = std::span(users).subspan(at(first[i]), at(first[i + 1] - first[i]));
    if (!own.empty() && std::find(own.begin(), own.end(), -1) == own.end()) products.push_back(own);
  }
  return fused_products(std::move(products), size);
}

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
    Cost c;
    std::set<std::tuple<int, int, int>> angles;  // kinds, indices and lanes of arguments
    for_each_statement([&](std::size_t, const Statement& s) {
      count_operation(c, s.op);
      if (s.op == Op::sine || s.op == Op::cosine) angles.emplace(static_cast<int>(s.a.kind), s.a.index, s.a.lane);
    });
    // The sine of a single lane costs nothing if the sines of all lanes are computed.
    c.sincos += static_cast<int>(std::count_if(angles.begin(), angles.end(), [&](const auto& angle) {
      const auto& [kind, index, lane] = angle;
      return lane < 0 || angles.count({kind, index, -1}) == 0;
    }));
    c.instructions = c.mul + c.add - fused(p_.statements.size(), [&](const auto& note) { for_each_use(note); });
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

  template <class Note>
  void for_each_use(const Note& note) const {
    for_each_statement([&](std::size_t i, const Statement& s) {
      for_each_operand(s, [&](const Operand& o) {
        if (is_product(o)) note(o.index, is_sum(s.op) && is_fusable(s, o) ? static_cast<int>(i) : -1);
      });
    });
    for (const OutputArray& array : p_.outputs)
      for (const Operand& o : array.values)
        if (is_product(o)) note(o.index, -1);
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
  for (const std::vector<Expression>& values : outputs)
    for (const Expression& e : values) needed[at(e.node())] = true;
  TracedCost result;
  Cost c;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const Node& n = nodes[i];
    if (!needed[i]) continue;
    if (n.kind == Node::Kind::constant)
      result.largest_constant = std::max(result.largest_constant, graph.constant_of(n).value());
    if (n.kind != Node::Kind::operation) continue;
    ++result.statements;
    count_operation(c, n.op);
    needed[at(n.a)] = true;
    if (n.b >= 0) needed[at(n.b)] = true;
  }
  c.instructions = c.mul + c.add - fused(nodes.size(), [&](const auto& note) {
                     for (std::size_t i = 0; i < nodes.size(); ++i) {
                       const Node& n = nodes[i];
                       if (!needed[i] || n.kind != Node::Kind::operation) continue;
                       const int user = is_sum(n.op) ? static_cast<int>(i) : -1;
                       for (const int operand : {n.a, n.b})
                         if (operand >= 0 && is_product(nodes[at(operand)])) note(operand, user);
                     }
                     for (const std::vector<Expression>& values : outputs)
                       for (const Expression& e : values)
                         if (is_product(nodes[at(e.node())])) note(e.node(), -1);
                   });
  result.work = weighted(c, kWork);
  return result;
}

int work_since(const Graph& graph, std::size_t mark) {
  const std::vector<Node>& nodes = graph.nodes();
  Cost c;
  int fused = 0;
  for (std::size_t i = mark; i < nodes.size(); ++i) {
    const Node& n = nodes[i];
    if (n.kind != Node::Kind::operation) continue;
    count_operation(c, n.op);
    if (is_sum(n.op) && (is_product(nodes[at(n.a)]) || is_product(nodes[at(n.b)]))) ++fused;
  }
  c.instructions = c.mul + c.add - fused;
  return weighted(c, kWork);
}

}  // namespace robcogen::symbolic
