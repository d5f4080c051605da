#include "import/parts/terms.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace robcogen::import::parts {
namespace {

using Kind = Expression::Kind;

ExpressionPtr node(Kind kind, Span span, ExpressionPtr left, ExpressionPtr right = nullptr) {
  Expression e;
  e.kind = kind;
  e.span = span;
  e.left = std::move(left);
  e.right = std::move(right);
  return std::make_shared<const Expression>(std::move(e));
}

ExpressionPtr literal(const Number& number, Span span) {
  Expression e;
  e.span = span;
  e.number = number;
  return std::make_shared<const Expression>(std::move(e));
}

ExpressionPtr pi(Span span) {
  Expression e;
  e.kind = Kind::pi;
  e.span = span;
  e.name = "PI";
  return std::make_shared<const Expression>(std::move(e));
}

Number whole(std::int64_t value) {
  return Number::rational(value);
}

// Folds an operation on constants. Sums and products associate to the left; they are folded only if both operands are
// constants.
std::optional<Number> folded(const Expression& e, const Number& a, const Number& b) {
  switch (e.kind) {
    case Kind::negate:
      return -a;
    case Kind::add:
      return a + b;
    case Kind::subtract:
      return a - b;
    case Kind::multiply:
      return a * b;
    case Kind::divide:
      return b.is_zero() ? std::nullopt : std::optional(a / b);
    case Kind::sine:
      return sin(a);
    case Kind::cosine:
      return cos(a);
    case Kind::tangent:
      return tan(a);
    case Kind::square_root:
      return sqrt(a);
    default:
      return std::nullopt;
  }
}

bool is(const ExpressionPtr& e, std::int64_t value) {
  const std::optional<Number> number = constant(e);
  return number && *number == whole(value);
}

ExpressionPtr operation(Kind kind, const ExpressionPtr& a, const ExpressionPtr& b = nullptr) {
  ExpressionPtr result = node(kind, a->span, a, b);
  const std::optional<Number> number = constant(result);
  return number ? term(*number, a->span) : result;
}

}  // namespace

std::optional<Number> constant(const ExpressionPtr& e) {
  if (e->kind == Kind::number) return e->number;
  if (e->kind == Kind::pi) return Number::pi_multiple(1);
  if (e->kind == Kind::name || e->kind == Kind::constant) return std::nullopt;
  const std::optional<Number> left = constant(e->left), right = e->right ? constant(e->right) : Number();
  if (!left || !right) return std::nullopt;
  const std::optional<Number> result = folded(*e, *left, *right);
  return result && std::isfinite(result->value()) ? result : std::nullopt;
}

bool is_zero(const ExpressionPtr& e) {
  const std::optional<Number> number = constant(e);
  return number && number->is_zero();
}

ExpressionPtr term(const Number& number, Span span) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53;  // integers up to here are doubles
  const std::optional<Rational>& r = number.ratio();
  if (!r || std::abs(r->num) > kExact || r->den > kExact) return literal(Number(number.value()), span);
  if (!number.is_pi_multiple()) {
    const std::optional<Number> read = Number::parse(print_double(number.value()));
    if (r->den == 1 || (read && *read == number)) return literal(number, span);
    return node(Kind::divide, span, literal(whole(r->num), span), literal(whole(r->den), span));
  }
  ExpressionPtr result = pi(span);
  if (r->num == -1)
    result = node(Kind::negate, span, result);
  else if (r->num != 1)
    result = node(Kind::multiply, span, literal(whole(r->num), span), result);
  return r->den == 1 ? result : node(Kind::divide, span, result, literal(whole(r->den), span));
}

ExpressionPtr negated(const ExpressionPtr& a) {
  if (const std::optional<Number> number = constant(a)) return number->is_zero() ? a : term(-*number, a->span);
  if (a->kind == Kind::negate) return a->left;
  if (a->kind == Kind::subtract) return difference(a->right, a->left);
  if (a->kind == Kind::add) return difference(negated(a->left), a->right);
  if (a->kind == Kind::multiply || a->kind == Kind::divide) {
    const bool keeps_left = a->kind == Kind::multiply && !constant(a->left) && constant(a->right);
    return keeps_left ? with_operands(*a, a->left, negated(a->right)) : with_operands(*a, negated(a->left), a->right);
  }
  return node(Kind::negate, a->span, a);
}

ExpressionPtr sum(const ExpressionPtr& a, const ExpressionPtr& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  if (b->kind == Kind::negate) return difference(a, b->left);
  return operation(Kind::add, a, b);
}

ExpressionPtr difference(const ExpressionPtr& a, const ExpressionPtr& b) {
  if (is_zero(a)) return negated(b);
  return is_zero(b) ? a : operation(Kind::subtract, a, b);
}

ExpressionPtr product(const ExpressionPtr& a, const ExpressionPtr& b) {
  if (is_zero(a) || is(b, 1)) return a;
  if (is_zero(b) || is(a, 1)) return b;
  if (is(a, -1)) return negated(b);
  if (is(b, -1)) return negated(a);
  if (a->kind == Kind::negate) return negated(product(a->left, b));
  if (b->kind == Kind::negate) return negated(product(a, b->left));
  if (constant(a) && b->kind == Kind::multiply && constant(b->left)) return product(product(a, b->left), b->right);
  return operation(Kind::multiply, a, b);
}

ExpressionPtr quotient(const ExpressionPtr& a, const ExpressionPtr& b) {
  return is(b, 1) || (is_zero(a) && !is_zero(b)) ? a : operation(Kind::divide, a, b);
}

ExpressionPtr sine(const ExpressionPtr& a) {
  return operation(Kind::sine, a);
}

ExpressionPtr cosine(const ExpressionPtr& a) {
  return operation(Kind::cosine, a);
}

ExpressionPtr with_operands(const Expression& e, const ExpressionPtr& left, const ExpressionPtr& right) {
  switch (e.kind) {
    case Kind::negate:
      return negated(left);
    case Kind::add:
      return sum(left, right);
    case Kind::subtract:
      return difference(left, right);
    case Kind::multiply:
      return product(left, right);
    case Kind::divide:
      return quotient(left, right);
    default:
      return operation(e.kind, left, right);
  }
}

}  // namespace robcogen::import::parts
