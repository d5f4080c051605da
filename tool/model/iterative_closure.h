// Loops that no formulas close. Newton's method closes them together.
#pragma once

#include <optional>
#include <vector>

#include "model/loop_context.h"

namespace robcogen::model {

// Returns a closure of these loops, and moves the dependent joints in `q` (by joint) to where they close. Reports loops
// that do not close, that remove more motions than there are joints that can follow, or whose rank differs nearby; the
// result is then nullopt.
std::optional<Closure> iterative_closure(LoopContext& context, const std::vector<int>& loops, std::vector<double>& q);

}  // namespace robcogen::model
