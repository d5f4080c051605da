// From quantities of the model to expressions of the documents.
#pragma once

#include <vector>

#include "language/common/expression.h"
#include "model/quantity.h"

namespace robcogen::exporting {

// An expression with the same value. It is exact if the quantity is: multiples of PI and fractions keep their form.
language::ExpressionPtr expression(
    const model::Quantity& quantity,
    const std::vector<model::Parameter>& parameters,
    const std::vector<std::string>& variables = {});

}  // namespace robcogen::exporting
