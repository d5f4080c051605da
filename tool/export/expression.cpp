#include "export/expression.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

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

// The number that the shortest literal of a double is parsed as.
Number as_read(double value) {
  assert(std::isfinite(value));
  return *Number::parse(print_double(value));
}

ExpressionPtr literal(double value) {
  Expression e;
  e.number = as_read(value);
  return std::make_shared<const Expression>(std::move(e));
}

// Whether a document does not read the word as a name.
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

ExpressionPtr signed_pi(bool negative) {
  return negative ? operation(Kind::negate, pi()) : pi();
}

// The constant in a form that the first RobCoGen reads: a number, `0.75 PI`, or `-PI/1.5`. It does not read quotients
// of numbers, so that a number without a finite decimal form becomes the nearest double.
ExpressionPtr constant(const Number& number) {
  if (!number.is_pi_multiple()) return literal(number.value());
  const auto [num, den] = *number.ratio();
  const bool is_negative = num < 0;
  const Number factor = Number::rational(num, den), divisor = Number::rational(den, is_negative ? -num : num);
  if (num == den || -num == den) return signed_pi(is_negative);
  if (den == 1 && is_literal(factor)) return operation(Kind::multiply, literal(factor.value()), pi());
  if (is_literal(divisor)) return operation(Kind::divide, signed_pi(is_negative), literal(divisor.value()));
  if (is_literal(factor)) return operation(Kind::multiply, literal(factor.value()), pi());
  return literal(number.value());
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
