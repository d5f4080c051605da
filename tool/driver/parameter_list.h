// Lists the parameters of a model for the user, so that a name that is a parameter by accident stands out.
#pragma once

#include <vector>

#include "model/quantity.h"
#include "support/diagnostics.h"

namespace robcogen::driver {

// Adds one note, by kinds: names with their defaults, and where each is declared or first used. Adds none if there are
// no parameters.
void list_parameters(const std::vector<model::Parameter>& parameters, Diagnostics& diagnostics);

}  // namespace robcogen::driver
