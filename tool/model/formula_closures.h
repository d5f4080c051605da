// Loops that formulas close: each in a plane, or a distance, one after another.
#pragma once

#include <optional>
#include <vector>

#include "model/loop_context.h"

namespace robcogen::model {

// Closures of these loops, in an order in which they can be solved; nullopt where no formulas close all of them, or
// where they close only together. Reports what no other method closes either, and then returns no closures.
std::optional<std::vector<Closure>> formula_closures(LoopContext& context, const std::vector<int>& loops);

// Moves the joints that follow in `q`, by joint, to where the loop closes, and sets its branch. Reports where it does
// not close, or is stretched.
void assemble_by_formula(LoopContext& context, Closure& closure, std::vector<double>& q);

}  // namespace robcogen::model
