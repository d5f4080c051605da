// Loops that closed-form formulas close one after another: planar loops, and distances.
#pragma once

#include <optional>
#include <vector>

#include "model/loop_context.h"

namespace robcogen::model {

// Returns the closures of these loops in an order in which they can be solved; nullopt if no formulas close all of
// them, or if they close only together. Reports loops that no other method closes either; the result is then empty.
std::optional<std::vector<Closure>> formula_closures(LoopContext& context, const std::vector<int>& loops);

// Moves the dependent joints in `q` (by joint) to where the loop closes, and sets the branch of the closure. Reports a
// loop that does not close there, or that is stretched.
void assemble_by_formula(LoopContext& context, Closure& closure, std::vector<double>& q);

}  // namespace robcogen::model
