#include "symbolic/weight.h"

#include <algorithm>
#include <cstdint>

#include "support/index.h"

namespace robcogen::symbolic {
namespace {

// The nodes that the outputs of a program need, and the products among them that disappear in sums.
class NeededNodes {
 public:
  NeededNodes(const Graph& graph, const std::vector<std::vector<Expression>>& outputs)
      : graph_(graph), nodes_(graph.nodes()), needed_(nodes_.size(), false), uses_(nodes_.size()) {
    for (const std::vector<Expression>& values : outputs)
      for (const Expression& e : values) {
        needed_[at(e.node())] = true;
        uses_[at(e.node())].is_elsewhere = true;
      }
    for (std::size_t i = nodes_.size(); i-- > 0;)
      if (needed_[i]) visit(i);
  }

  Weight weight() const {
    Weight result = found_;
    result.work -= fused_products();
    return result;
  }

 private:
  struct Uses {
    int sums = 0;
    int last_sum = -1;
    bool is_elsewhere = false;  // by what is not a sum
  };

  const Graph& graph_;
  const std::vector<Node>& nodes_;
  std::vector<char> needed_;
  std::vector<Uses> uses_;
  Weight found_;  // products not fused

  bool is_product(std::size_t i) const {
    return nodes_[i].kind == Node::Kind::operation && nodes_[i].op == Op::multiply;
  }

  void visit(std::size_t i) {
    const Node& n = nodes_[i];
    if (n.kind == Node::Kind::constant)
      found_.largest_constant = std::max(found_.largest_constant, graph_.constant_of(n).value());
    if (n.kind != Node::Kind::operation) return;
    ++found_.statements;
    if (is_binary(n.op)) found_.work += 2;
    const bool adds = is_sum(n.op);
    for (const int operand : {n.a, n.b}) {
      if (operand < 0) continue;
      needed_[at(operand)] = true;
      Uses& uses = uses_[at(operand)];
      if (adds) {
        ++uses.sums;
        uses.last_sum = static_cast<int>(i);
      } else {
        uses.is_elsewhere = true;
      }
    }
  }

  // As count.cpp fuses them: those with one use, then those with more, fewest first.
  int fused_products() const {
    std::vector<char> taken(nodes_.size(), false);
    std::vector<int> with_more_uses, place(nodes_.size(), -1);
    int fused = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Uses& uses = uses_[i];
      if (uses.sums == 0 || uses.is_elsewhere || !is_product(i)) continue;
      if (uses.sums > 1) {
        with_more_uses.push_back(static_cast<int>(i));
      } else if (!taken[at(uses.last_sum)]) {
        taken[at(uses.last_sum)] = true;
        ++fused;
      }
    }
    std::vector<int> sums;
    for (const int product : with_more_uses) {
      place[at(product)] = static_cast<int>(sums.size());
      sums.resize(sums.size() + at(uses_[at(product)].sums));
    }
    std::vector<int> next = place;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!needed_[i] || nodes_[i].kind != Node::Kind::operation || !is_sum(nodes_[i].op)) continue;
      for (const int operand : {nodes_[i].a, nodes_[i].b})
        if (next[at(operand)] >= 0) sums[at(next[at(operand)]++)] = static_cast<int>(i);
    }
    std::stable_sort(with_more_uses.begin(), with_more_uses.end(), [&](int a, int b) {
      return uses_[at(a)].sums < uses_[at(b)].sums;
    });
    for (const int product : with_more_uses) {
      const auto first = sums.begin() + place[at(product)], last = first + uses_[at(product)].sums;
      if (std::any_of(first, last, [&](int sum) { return taken[at(sum)]; })) continue;
      for (auto sum = first; sum != last; ++sum) taken[at(*sum)] = true;
      ++fused;
    }
    return fused;
  }
};

}  // namespace

Weight weight(const Graph& graph, const std::vector<std::vector<Expression>>& outputs) {
  return NeededNodes(graph, outputs).weight();
}

}  // namespace robcogen::symbolic
