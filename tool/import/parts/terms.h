// Arithmetic on expressions of documents. Constants are folded, exactly if they are exact; operations with zero and one
// are simplified.
#pragma once

#include <optional>

#include "language/common/expression.h"

namespace robcogen::import::parts {

using language::Expression;
using language::ExpressionPtr;

// Returns the value of an expression without parameters; nullopt if it has none.
std::optional<Number> constant(const ExpressionPtr& e);
bool is_zero(const ExpressionPtr& e);

// Returns the expression of a number as a document spells it: `0.35`, `PI/2.0`.
ExpressionPtr term(const Number& number, Span span);

ExpressionPtr negated(const ExpressionPtr& a);
ExpressionPtr sum(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr difference(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr product(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr quotient(const ExpressionPtr& a, const ExpressionPtr& b);
ExpressionPtr sine(const ExpressionPtr& a);
ExpressionPtr cosine(const ExpressionPtr& a);

// Returns the same operation as `e` on other operands.
ExpressionPtr with_operands(const Expression& e, const ExpressionPtr& left, const ExpressionPtr& right);

}  // namespace robcogen::import::parts
