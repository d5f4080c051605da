#include "export/expression.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "language/kinematics/keywords.h"

namespace robcogen::exporting {

using language::Expression;
using language::ExpressionPtr;
using model::Quantity;
using Kind = Expression::Kind;

namespace {

ExpressionPtr operation(Kind kind, ExpressionPtr left, ExpressionPtr right = nullptr) {
  Expression e;
  e.kind = kind;
  e.left = std::move(left);
  e.right = std::move(right);
  return std::make_shared<const Expression>(std::move(e));
}

// The number that a reader makes of the shortest literal of a double.
Number as_read(double value) {
  assert(std::isfinite(value));
  return *Number::parse(print_double(value));
}

ExpressionPtr literal(double value) {
  Expression e;
  e.number = as_read(value);
  return std::make_shared<const Expression>(std::move(e));
}

// What a document would not take for a name.
bool is_reserved(const std::string& name) {
  std::string lower_case = name;
  for (char& c : lower_case)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const auto words = {"pi", "nan", "inf", "infinity"};
  return std::find(words.begin(), words.end(), lower_case) != words.end() || language::kinematics::is_keyword(name);
}

ExpressionPtr named(const std::string& name, std::optional<double> default_value = std::nullopt) {
  Expression e;
  e.kind = Kind::name;
  e.name = name;
  e.escaped = is_reserved(name);
  if (default_value) e.default_value = as_read(*default_value);
  return std::make_shared<const Expression>(std::move(e));
}

ExpressionPtr pi() {
  Expression e;
  e.kind = Kind::pi;
  e.name = "PI";
  return std::make_shared<const Expression>(std::move(e));
}

// Whether a literal holds the number in its exact form.
bool is_literal(const Number& number) {
  return as_read(number.value()) == number;
}

// A numerator of PI/den, without a factor of one: `PI`, `-PI`, `-2.0 PI`.
ExpressionPtr pi_times(std::int64_t factor) {
  if (factor == 1) return pi();
  if (factor == -1) return operation(Kind::negate, pi());
  return operation(Kind::multiply, literal(static_cast<double>(factor)), pi());
}

// `2.0 PI/3.0`, `-PI/2.0`, `1.0/3.0`, or the nearest literal.
ExpressionPtr constant(const Number& number) {
  const auto& ratio = number.ratio();
  const bool is_fraction =
      ratio && is_literal(Number::rational(ratio->num)) && is_literal(Number::rational(ratio->den));
  if (!is_fraction || is_literal(number)) return literal(number.value());
  const ExpressionPtr dividend =
      number.is_pi_multiple() ? pi_times(ratio->num) : literal(static_cast<double>(ratio->num));
  return ratio->den == 1 ? dividend : operation(Kind::divide, dividend, literal(static_cast<double>(ratio->den)));
}

Kind kind_of(Quantity::Op op) {
  switch (op) {
    case Quantity::Op::negate:
      return Kind::negate;
    case Quantity::Op::add:
      return Kind::add;
    case Quantity::Op::subtract:
      return Kind::subtract;
    case Quantity::Op::multiply:
      return Kind::multiply;
    case Quantity::Op::divide:
      return Kind::divide;
    case Quantity::Op::sine:
      return Kind::sine;
    case Quantity::Op::cosine:
      return Kind::cosine;
    case Quantity::Op::tangent:
      return Kind::tangent;
    case Quantity::Op::square_root:
      return Kind::square_root;
    case Quantity::Op::constant:
    case Quantity::Op::parameter:
    case Quantity::Op::variable:
      break;
  }
  assert(false && "no operation");
  return Kind::number;
}

}  // namespace

ExpressionPtr expression(
    const Quantity& quantity,
    const std::vector<model::Parameter>& parameters,
    const std::vector<std::string>& variables) {
  switch (quantity.op()) {
    case Quantity::Op::constant:
      return constant(quantity.number());
    case Quantity::Op::parameter: {
      const model::Parameter& parameter = parameters[static_cast<std::size_t>(quantity.index())];
      return named(parameter.name, parameter.default_value);
    }
    case Quantity::Op::variable:
      return named(variables[static_cast<std::size_t>(quantity.index())]);
    case Quantity::Op::negate:
    case Quantity::Op::sine:
    case Quantity::Op::cosine:
    case Quantity::Op::tangent:
    case Quantity::Op::square_root:
      return operation(kind_of(quantity.op()), expression(quantity.left(), parameters, variables));
    case Quantity::Op::add:
    case Quantity::Op::subtract:
    case Quantity::Op::multiply:
    case Quantity::Op::divide:
      break;
  }
  return operation(
      kind_of(quantity.op()), expression(quantity.left(), parameters, variables),
      expression(quantity.right(), parameters, variables));
}

}  // namespace robcogen::exporting
