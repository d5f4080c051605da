// From quantities of the model to expressions of the documents.
#pragma once

#include <vector>

#include "language/common/expression.h"
#include "model/quantity.h"

namespace robcogen::exporting {

// An expression of the same value: exact where the quantity is, so multiples of PI and fractions are written as such.
language::ExpressionPtr expression(
    const model::Quantity& quantity,
    const std::vector<model::Parameter>& parameters,
    const std::vector<std::string>& variables = {});

}  // namespace robcogen::exporting
