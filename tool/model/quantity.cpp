#include "model/quantity.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace robcogen::model {

struct Quantity::Node {
  Op op = Op::constant;
  Number number;
  int index = 0;
  Quantity left = Quantity(std::shared_ptr<const Node>());
  Quantity right = Quantity(std::shared_ptr<const Node>());

  static Quantity leaf(Op op, int index) {
    Node node;
    node.op = op;
    node.index = index;
    return Quantity(std::make_shared<const Node>(std::move(node)));
  }
  static Quantity unary(Op op, const Quantity& a) {
    Node node;
    node.op = op;
    node.left = a;
    return Quantity(std::make_shared<const Node>(std::move(node)));
  }
  static Quantity binary(Op op, const Quantity& a, const Quantity& b) {
    Node node;
    node.op = op;
    node.left = a;
    node.right = b;
    return Quantity(std::make_shared<const Node>(std::move(node)));
  }
};

namespace {

bool is_value(const Quantity& q, double value) {
  return q.is_constant() && q.number().value() == value;
}

}  // namespace

Quantity::Quantity(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

Quantity::Quantity() {
  static const std::shared_ptr<const Node> zero = std::make_shared<const Node>();
  node_ = zero;
}

Quantity::Quantity(Number value) {
  Node node;
  node.number = value;
  node_ = std::make_shared<const Node>(std::move(node));
}

Quantity Quantity::parameter(int index) {
  return Node::leaf(Op::parameter, index);
}
Quantity Quantity::variable(int index) {
  return Node::leaf(Op::variable, index);
}

Quantity::Op Quantity::op() const {
  return node_->op;
}

const Number& Quantity::number() const {
  assert(op() == Op::constant);
  return node_->number;
}

int Quantity::index() const {
  assert(op() == Op::parameter || op() == Op::variable);
  return node_->index;
}

const Quantity& Quantity::left() const {
  assert(node_->left.node_ && "a constant, parameter or variable has no operand");
  return node_->left;
}

const Quantity& Quantity::right() const {
  assert(node_->right.node_ && "not a binary operation");
  return node_->right;
}

bool operator==(const Quantity& a, const Quantity& b) {
  if (a.node_ == b.node_) return true;
  if (!a.node_ || !b.node_ || a.op() != b.op()) return false;
  const Quantity::Node &x = *a.node_, &y = *b.node_;
  return x.number == y.number && x.index == y.index && x.left == y.left && x.right == y.right;
}

Quantity operator-(const Quantity& a) {
  if (a.is_constant()) return Quantity(-a.number());
  if (a.op() == Quantity::Op::negate) return a.left();
  return Quantity::Node::unary(Quantity::Op::negate, a);
}

Quantity operator+(const Quantity& a, const Quantity& b) {
  if (a.is_constant() && b.is_constant()) return Quantity(a.number() + b.number());
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  if (b.op() == Quantity::Op::negate) return a - b.left();
  return Quantity::Node::binary(Quantity::Op::add, a, b);
}

Quantity operator-(const Quantity& a, const Quantity& b) {
  if (a.is_constant() && b.is_constant()) return Quantity(a.number() - b.number());
  if (a.is_zero()) return -b;
  if (b.is_zero()) return a;
  if (b.op() == Quantity::Op::negate) return a + b.left();
  return Quantity::Node::binary(Quantity::Op::subtract, a, b);
}

Quantity operator*(const Quantity& a, const Quantity& b) {
  if (a.is_constant() && b.is_constant()) return Quantity(a.number() * b.number());
  if (a.is_zero() || b.is_zero()) return Quantity();
  if (is_value(a, 1.0)) return b;
  if (is_value(b, 1.0)) return a;
  if (is_value(a, -1.0)) return -b;
  if (is_value(b, -1.0)) return -a;
  // The product of a mass and a centre of mass that was divided by it: the mass may be zero at run time.
  if (b.op() == Quantity::Op::divide && !a.is_constant() && b.right() == a) return b.left();
  return Quantity::Node::binary(Quantity::Op::multiply, a, b);
}

Quantity operator/(const Quantity& a, const Quantity& b) {
  if (a.is_constant() && b.is_constant()) return Quantity(a.number() / b.number());
  if (is_value(b, 1.0)) return a;
  if (is_value(b, -1.0)) return -a;
  if (a.is_zero()) return Quantity();
  return Quantity::Node::binary(Quantity::Op::divide, a, b);
}

Quantity sin(const Quantity& a) {
  return a.is_constant() ? Quantity(sin(a.number())) : Quantity::Node::unary(Quantity::Op::sine, a);
}

Quantity cos(const Quantity& a) {
  return a.is_constant() ? Quantity(cos(a.number())) : Quantity::Node::unary(Quantity::Op::cosine, a);
}

Quantity tan(const Quantity& a) {
  return a.is_constant() ? Quantity(tan(a.number())) : Quantity::Node::unary(Quantity::Op::tangent, a);
}

Quantity sqrt(const Quantity& a) {
  return a.is_constant() ? Quantity(sqrt(a.number())) : Quantity::Node::unary(Quantity::Op::square_root, a);
}

double evaluate(const Quantity& q, std::span<const double> parameters, std::span<const double> variables) {
  const auto value = [&](const Quantity& operand) { return evaluate(operand, parameters, variables); };
  switch (q.op()) {
    case Quantity::Op::constant:
      return q.number().value();
    case Quantity::Op::parameter:
      return parameters[static_cast<std::size_t>(q.index())];
    case Quantity::Op::variable:
      return variables[static_cast<std::size_t>(q.index())];
    case Quantity::Op::negate:
      return -value(q.left());
    case Quantity::Op::add:
      return value(q.left()) + value(q.right());
    case Quantity::Op::subtract:
      return value(q.left()) - value(q.right());
    case Quantity::Op::multiply:
      return value(q.left()) * value(q.right());
    case Quantity::Op::divide:
      return value(q.left()) / value(q.right());
    case Quantity::Op::sine:
      return std::sin(value(q.left()));
    case Quantity::Op::cosine:
      return std::cos(value(q.left()));
    case Quantity::Op::tangent:
      return std::tan(value(q.left()));
    case Quantity::Op::square_root:
      return std::sqrt(value(q.left()));
  }
  assert(false && "unknown operation");
  return 0.0;
}

std::optional<double> value_at_defaults(
    const Quantity& q,
    const std::vector<Parameter>& parameters,
    std::size_t variables) {
  if (q.is_constant()) return q.number().value();
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> defaults;
  for (const Parameter& p : parameters) defaults.push_back(p.default_value.value_or(kUnknown));
  const double value = evaluate(q, defaults, std::vector<double>(variables, kUnknown));
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

// --- printing --------------------------------------------------------------------------------------------------

namespace {

// How tightly the outermost operator of a text binds.
enum class Binding { sum, product, sign, atom };

struct Text {
  std::string text;
  Binding binding = Binding::atom;
};

class Printer {
 public:
  Printer(const std::vector<Parameter>& parameters, const std::vector<std::string>& variables)
      : parameters_(parameters), variables_(variables) {}

  Text print(const Quantity& q) const {
    switch (q.op()) {
      case Quantity::Op::constant:
        return constant(q.number());
      case Quantity::Op::parameter:
        return {parameters_[static_cast<std::size_t>(q.index())].name, Binding::atom};
      case Quantity::Op::variable:
        return {variables_[static_cast<std::size_t>(q.index())], Binding::atom};
      case Quantity::Op::negate:
        return {fmt::format("-{}", enclose(q.left(), Binding::atom)), Binding::sign};
      case Quantity::Op::add:
        return {enclose(q.left(), Binding::sum) + " + " + right(q.right(), Binding::product), Binding::sum};
      case Quantity::Op::subtract:
        return {enclose(q.left(), Binding::sum) + " - " + right(q.right(), Binding::product), Binding::sum};
      case Quantity::Op::multiply:
        return product(q);
      case Quantity::Op::divide:
        return {enclose(q.left(), Binding::product) + "/" + right(q.right(), Binding::sign), Binding::product};
      case Quantity::Op::sine:
        return function("sin", q);
      case Quantity::Op::cosine:
        return function("cos", q);
      case Quantity::Op::tangent:
        return function("tan", q);
      case Quantity::Op::square_root:
        return function("sqrt", q);
    }
    assert(false && "unknown operation");
    return {};
  }

 private:
  static Text constant(const Number& number) {
    std::string text = robcogen::print(number);
    const bool plain = text.find_first_of("P/* ") == std::string::npos;
    const Binding binding = !plain ? Binding::product : text.front() == '-' ? Binding::sign : Binding::atom;
    return {std::move(text), binding};
  }

  static std::string parenthesise(const Text& t) { return fmt::format("({})", t.text); }

  std::string enclose(const Quantity& q, Binding at_least) const {
    const Text t = print(q);
    return t.binding < at_least ? parenthesise(t) : t.text;
  }

  // A right operand that starts with a sign is enclosed, so that two operators are never adjacent.
  std::string right(const Quantity& q, Binding at_least) const {
    const Text t = print(q);
    return t.binding < at_least || t.text.front() == '-' ? parenthesise(t) : t.text;
  }

  // Prints a number times a name as `0.5 length`, the only product that every dialect can read, and other products as
  // `a*b`.
  Text product(const Quantity& q) const {
    const Text left = print(q.left());
    const bool left_is_plain = q.left().is_constant() && left.binding != Binding::product;
    const bool right_is_name = q.right().op() == Quantity::Op::parameter || q.right().op() == Quantity::Op::variable;
    const std::string separator = left_is_plain && right_is_name ? " " : "*";
    return {enclose(q.left(), Binding::product) + separator + right(q.right(), Binding::sign), Binding::product};
  }

  Text function(const char* name, const Quantity& q) const {
    return {name + parenthesise(print(q.left())), Binding::atom};
  }

  const std::vector<Parameter>& parameters_;
  const std::vector<std::string>& variables_;
};

}  // namespace

namespace {

bool has_right(Quantity::Op op) {
  return op == Quantity::Op::add || op == Quantity::Op::subtract || op == Quantity::Op::multiply ||
         op == Quantity::Op::divide;
}

}  // namespace

std::vector<int> parameters_of(const Quantity& q) {
  switch (q.op()) {
    case Quantity::Op::constant:
    case Quantity::Op::variable:
      return {};
    case Quantity::Op::parameter:
      return {q.index()};
    default:
      break;
  }
  std::vector<int> result = parameters_of(q.left());
  if (has_right(q.op())) {
    const std::vector<int> more = parameters_of(q.right());
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

std::string print(
    const Quantity& q,
    const std::vector<Parameter>& parameters,
    const std::vector<std::string>& variables) {
  return Printer(parameters, variables).print(q).text;
}

}  // namespace robcogen::model
