// All quantities of a description, one by one.
#pragma once

#include <functional>
#include <vector>

#include "model/description.h"

namespace robcogen::model {

void visit_quantities(Description& description, const std::function<void(Quantity&)>& visit);

// Replaces each parameter by `values`, which are indexed by parameter.
Quantity with_parameters(const Quantity& q, const std::vector<Quantity>& values);

// Removes the parameters that no quantity depends on.
void remove_unused_parameters(Description& description);

}  // namespace robcogen::model
