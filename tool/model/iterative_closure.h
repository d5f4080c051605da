// Loops that no formulas close: together, by Newton's method.
#pragma once

#include <optional>
#include <vector>

#include "model/loop_context.h"

namespace robcogen::model {

// A closure of these loops. Moves the joints that follow in `q`, by joint, to where they close. Reports loops that do
// not close, that take away more motions than there are joints to follow, and ranks that differ nearby; then nullopt.
std::optional<Closure> iterative_closure(LoopContext& context, const std::vector<int>& loops, std::vector<double>& q);

}  // namespace robcogen::model
