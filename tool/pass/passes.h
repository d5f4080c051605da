// Passes from a program to an equivalent program. Each pass can be left out; results then differ by rounding only.
#pragma once

#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::pass {

// Rebuilds the program through the folding rules of symbolic::Graph: constants, zeros, ones, k1 (k2 x), k1 x + k2 x,
// (x + c1) + c2, (p + q) - q. Equal statements are computed once, and statements that no output needs are dropped.
symbolic::Program canonical(symbolic::Program program);

// Reorders sums that nothing else reads so that each addition can be fused with a product.
symbolic::Program reassociate(symbolic::Program program);

// Moves each statement to the latest section that still precedes all its uses: values live shorter, sections stay
// whole.
symbolic::Program sink(symbolic::Program program);

// Names of all passes, in the order in which they run.
const std::vector<std::string>& names();

// Runs the named passes in canonical order; an unknown name is an internal fault (std::logic_error).
symbolic::Program run(symbolic::Program program, const std::vector<std::string>& passes = names());

}  // namespace robcogen::pass
