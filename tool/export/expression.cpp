#include "export/expression.h"

#include <cassert>

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

ExpressionPtr literal(const Number& number) {
  Expression e;
  e.number = number;
  return std::make_shared<const Expression>(std::move(e));
}

ExpressionPtr named(Kind kind, const std::string& name, std::optional<double> default_value = std::nullopt) {
  Expression e;
  e.kind = kind;
  e.name = name;
  if (default_value) e.default_value = Number(*default_value);
  return std::make_shared<const Expression>(std::move(e));
}

// Whether a literal can hold the number in its exact form.
bool is_literal(const Number& number) {
  return !number.is_pi_multiple() && Number::parse(print_double(number.value())) == number;
}

// `2.0 PI/3.0`, `-PI/2.0`, `1.0/3.0`, or the nearest literal.
ExpressionPtr constant(const Number& number) {
  const auto ratio = number.ratio();
  if (!ratio || is_literal(number)) return literal(Number(number.value()));
  const Number num = Number::rational(ratio->num), den = Number::rational(ratio->den);
  if (!is_literal(num) || !is_literal(den)) return literal(Number(number.value()));
  ExpressionPtr dividend = literal(num);
  if (number.is_pi_multiple()) {
    const ExpressionPtr pi = named(Kind::pi, "PI");
    const bool is_unit = ratio->num == 1 || ratio->num == -1;
    dividend = !is_unit ? operation(Kind::multiply, dividend, pi) : ratio->num < 0 ? operation(Kind::negate, pi) : pi;
  }
  return ratio->den == 1 ? dividend : operation(Kind::divide, dividend, literal(den));
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
      return named(Kind::name, parameter.name, parameter.default_value);
    }
    case Quantity::Op::variable:
      return named(Kind::name, variables[static_cast<std::size_t>(quantity.index())]);
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
