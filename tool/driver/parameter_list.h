// The parameters of a model, told to the user: a name that became one by accident stands out.
#pragma once

#include <vector>

#include "model/quantity.h"
#include "support/diagnostics.h"

namespace robcogen::driver {

// One note, by kinds: names with their defaults, and where each is declared or first used. Nothing where
// there are none.
void list_parameters(const std::vector<model::Parameter>& parameters, Diagnostics& diagnostics);

}  // namespace robcogen::driver
