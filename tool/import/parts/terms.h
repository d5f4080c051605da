// Arithmetic on expressions of documents. Constants are folded, exactly where they are exact; zeros and ones vanish.
#pragma once

#include <optional>

#include "language/common/expression.h"

namespace robcogen::import::parts {

using language::Expression;
using language::ExpressionPtr;

// The value of an expression without parameters; nullopt where there is none.
std::optional<Number> constant(const ExpressionPtr& e);
bool is_zero(const ExpressionPtr& e);

// As a document spells it: `0.35`, `PI/2.0`.
ExpressionPtr term(const Number& number, Span span);

ExpressionPtr negated(const ExpressionPtr& a);
ExpressionPtr sum(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr difference(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr product(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr quotient(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr sine(const ExpressionPtr& a);
ExpressionPtr cosine(const ExpressionPtr& a);

// The same operation as `e`, on other operands.
ExpressionPtr with_operands(const Expression& e, const ExpressionPtr& left, const ExpressionPtr& right);

}  // namespace robcogen::import::parts
