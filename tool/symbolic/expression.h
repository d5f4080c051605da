// Scalar expressions that fold constants and share subexpressions while they are built: algorithms use them like any
// other scalar.
//
// A Graph holds each distinct operation once (hash-consing), so common subexpressions cost nothing by construction. An
// Expression is a node with a sign: -x is free, a - b and b - a are one node. Zeros, ones and constants fold, multiples
// of PI exactly, so the structural sparsity of joints, inertias and branches needs no special code in the algorithms.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/number.h"
#include "symbolic/constant.h"
#include "symbolic/program.h"
#include "symbolic/quantity.h"

namespace robcogen::symbolic {

class Graph;

// Default: the constant zero, which belongs to every graph.
class Expression {
 public:
  Expression() = default;

  bool is_constant() const;
  bool is_zero() const { return node_ == 0; }
  bool is_one() const { return node_ == 1 && !negative_; }
  // The signed value of a constant.
  Constant constant() const;
  Number number() const { return constant().number(); }

  Graph* graph() const { return graph_; }
  int node() const { return node_; }
  bool negative() const { return negative_; }

  friend bool operator==(const Expression& a, const Expression& b) {
    return a.node_ == b.node_ && a.negative_ == b.negative_;
  }
  friend Expression operator-(const Expression& a) {
    return a.is_zero() ? a : Expression(a.graph_, a.node_, !a.negative_);
  }
  friend Expression operator+(const Expression& a, const Expression& b);
  friend Expression operator-(const Expression& a, const Expression& b) { return a + (-b); }
  friend Expression operator*(const Expression& a, const Expression& b);
  friend Expression operator/(const Expression& a, const Expression& b);
  friend Expression operator*(double a, const Expression& b);
  friend Expression sqrt(const Expression& a);
  friend Expression sin(const Expression& a);
  friend Expression cos(const Expression& a);
  // The angle with this sine and this cosine, whose squares must add up to one. The sine and cosine of the result fold
  // back to them.
  friend Expression atan2(const Expression& sine, const Expression& cosine);
  Expression& operator+=(const Expression& b) { return *this = *this + b; }
  Expression& operator-=(const Expression& b) { return *this = *this - b; }

 private:
  friend class Graph;
  Expression(Graph* graph, int node, bool negative) : graph_(graph), node_(node), negative_(negative) {}

  Graph* graph_ = nullptr;
  int node_ = 0;
  bool negative_ = false;
};

struct Node {
  enum class Kind : std::uint8_t { constant, input, operation };
  Kind kind = Kind::constant;
  Op op = Op::add;
  bool a_negative = false;  // of square roots only: other operations move the sign outwards
  bool b_negative = false;  // of the cosine of an arc tangent only
  int a = -1;               // constant: index into constants; input: flat element index; operation: first operand
  int b = -1;
  friend bool operator==(const Node&, const Node&) = default;
};

class Graph {
 public:
  Graph();
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  Expression constant(const Constant& value);
  Expression constant(const Number& value) { return constant(Constant(value)); }
  Expression constant(double value) { return constant(Constant(Number(value))); }
  Expression one() { return Expression(this, 1, false); }
  Expression input(int element);
  // An operand of a node.
  Expression expression(int node, bool negative) { return Expression(this, node, negative); }

  // A checkpoint, and the return to it, which forgets everything that was built since. Used to compare the work of
  // variants (cost.h).
  std::size_t mark() const { return nodes_.size(); }
  void rollback(std::size_t mark);

  // For programs that are only counted: from now on sections and names are ignored, and statements have no names.
  void forget_names() { names_matter_ = false; }
  bool keeps_names() const { return names_matter_; }
  // Nodes created from now on belong to this section.
  void begin_section(std::string title, std::string prefix);
  // Says what the value is, unless that is known, or it is a constant or an input. It becomes a statement of its own.
  void name(const Expression& e, Quantity quantity) { set_quantity(e, std::move(quantity), true); }
  // Like `name`, for a value that passes and back ends may still split or merge into another statement: the quantity is
  // used if a statement with this value remains. A quantity given by `name` replaces it.
  void describe(const Expression& e, Quantity quantity) { set_quantity(e, std::move(quantity), false); }
  // The same as the statement of another program.
  void name(const Expression& e, const Statement& s);
  // Whether `name` (is_own) or `describe` would have an effect.
  bool takes_quantity(const Expression& e, bool is_own) const;
  // The subject of the current section: `lowerleg`.
  const std::string& subject() const { return sections_.back().prefix; }

  const std::vector<Node>& nodes() const { return nodes_; }
  // Makes room for so many nodes.
  void reserve(std::size_t nodes);
  const Constant& constant_of(const Node& n) const { return constants_[static_cast<std::size_t>(n.a)]; }

  // The program that computes these outputs: reachable operations in the order of their creation. `outputs[k]` supplies
  // the values of `shapes[k]`.
  Program program(
      std::string name,
      std::vector<InputArray> inputs,
      std::vector<OutputArray> shapes,
      const std::vector<std::vector<Expression>>& outputs) const;

 private:
  friend Expression operator+(const Expression&, const Expression&);
  friend Expression operator*(const Expression&, const Expression&);
  friend Expression operator/(const Expression&, const Expression&);
  friend Expression operator*(double, const Expression&);
  friend Expression sqrt(const Expression&);
  friend Expression sin(const Expression&);
  friend Expression cos(const Expression&);
  friend Expression atan2(const Expression&, const Expression&);

  struct NodeQuantity {
    QuantityRef quantity;  // of the node, which has no sign
    bool is_own = false;   // given by `name`
  };

  void set_quantity(const Expression& e, Quantity quantity, bool is_own);
  std::uint32_t hash(const Node& n) const;
  // Whether both nodes are the same operation, input or constant.
  bool is_same(const Node& m, const Node& n) const;
  bool are_same_constants(const Node& m, const Node& n) const;  // n is a constant
  // The index in known_ at which the same node, with this hash, is or would be stored.
  std::size_t slot(const Node& n, std::uint32_t hash) const;
  void resize_table(std::size_t size);
  int intern(const Node& n);
  Expression operation(Op op, const Expression& a, const Expression& b);
  Expression add(Expression a, Expression b);
  // The sum of a and b, at least one of which is a sum, if terms of both fold.
  std::optional<Expression> folded_sum(const Expression& a, const Expression& b);
  Expression multiply(Expression a, Expression b);
  bool is_constant(int node) const { return nodes_[static_cast<std::size_t>(node)].kind == Node::Kind::constant; }
  static bool is_product(const Node& n) { return n.kind == Node::Kind::operation && n.op == Op::multiply; }
  static bool is_sum(const Node& n) { return n.kind == Node::Kind::operation && symbolic::is_sum(n.op); }
  const Node& node_of(const Expression& e) const { return nodes_[static_cast<std::size_t>(e.node())]; }
  Expression positive(int node) { return Expression(this, node, false); }
  // A node as factor * rest; factor is the node of a constant, or of one if the node has no constant factor.
  struct Scaled {
    int factor, rest;
  };
  Scaled split_factor(int node) const;
  // The signed factor of an expression that was split.
  Constant factor(const Expression& x, const Scaled& split) const;
  // The sine and the cosine of an arc tangent, or of a sum or difference that contains one.
  std::optional<std::array<Expression, 2>> known_sine_cosine(const Expression& angle);
  // The two terms of a sum or difference.
  std::array<Expression, 2> terms(const Expression& x);

  bool names_matter_ = true;
  std::vector<Node> nodes_;
  std::vector<Constant> constants_;
  std::vector<NodeQuantity> quantities_;  // up to the last node that has one
  std::vector<Section> sections_;
  std::vector<std::size_t> section_starts_;  // by section: its first node, or the next one if it has none
  // A hash table of the nodes: open addressing, at most half full, -1 for an empty slot. The last node can be removed
  // by clearing its slot, since no node was inserted after it. Most other nodes that a search passes have another hash
  // and need not be compared.
  struct KnownNode {
    std::uint32_t hash = 0;
    int node = -1;
  };
  std::vector<KnownNode> known_;
};

}  // namespace robcogen::symbolic
