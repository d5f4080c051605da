// One program in place of several.
#pragma once

#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::symbolic {

// A program with the outputs of all parts, part by part. Its inputs are those of the parts in canonical order; inputs
// of one name are one. Values that several parts compute in the same way are computed once.
Program fused(const std::string& name, const std::vector<Program>& parts);

// The inputs and outputs of that program. `outlines` need not have statements.
Program fused_outline(const std::string& name, const std::vector<Program>& outlines);

}  // namespace robcogen::symbolic
