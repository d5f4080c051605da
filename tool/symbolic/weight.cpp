#include "symbolic/weight.h"

#include <algorithm>
#include <span>
#include <utility>

#include "support/index.h"
#include "symbolic/fused_products.h"

namespace robcogen::symbolic {
namespace {

// The nodes that the outputs of a program need, and the products among them that are fused into sums.
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
    result.work -= fused();
    return result;
  }

 private:
  struct Uses {
    int sums = 0;
    bool is_elsewhere = false;  // by something other than a sum
  };

  const Graph& graph_;
  const std::vector<Node>& nodes_;
  std::vector<char> needed_;
  std::vector<Uses> uses_;
  Weight found_;  // before products are fused

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
      if (adds)
        ++uses.sums;
      else
        uses.is_elsewhere = true;
    }
  }

  int fused() const {
    std::vector<int> next(nodes_.size(), -1);  // by product: place in `sums` of its next use
    int length = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Uses& uses = uses_[i];
      if (uses.sums == 0 || uses.is_elsewhere || !is_product(i)) continue;
      next[i] = length;
      length += uses.sums;
    }
    std::vector<int> sums(at(length));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!needed_[i] || nodes_[i].kind != Node::Kind::operation || !is_sum(nodes_[i].op)) continue;
      for (const int operand : {nodes_[i].a, nodes_[i].b})
        if (next[at(operand)] >= 0) sums[at(next[at(operand)]++)] = static_cast<int>(i);
    }
    std::vector<std::span<const int>> products;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (next[i] >= 0)
        products.push_back(std::span<const int>(sums).subspan(at(next[i] - uses_[i].sums), at(uses_[i].sums)));
    return fused_products(std::move(products), nodes_.size());
  }
};

}  // namespace

Weight weight(const Graph& graph, const std::vector<std::vector<Expression>>& outputs) {
  return NeededNodes(graph, outputs).weight();
}

}  // namespace robcogen::symbolic
