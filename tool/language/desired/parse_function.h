// Parses definitions of functions that are fused of others: `control = bias_forces + jacobians.fr_base_J_fr_foot`.
#pragma once

#include <memory>
#include <vector>

#include "language/common/cursor.h"
#include "language/desired/document.h"

namespace robcogen::language::desired {

Function read_function(Cursor& cursor);

// Parses a text of definitions, of an option for example. Reports every error.
std::vector<Function> parse_functions(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

}  // namespace robcogen::language::desired
