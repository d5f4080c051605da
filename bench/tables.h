// The report as text for a console.
#pragma once

#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// For the generated functions: times, operation counts, the lower bound of a call, and bytes of the kernels; a line
// about the robot comes before its functions.
std::string function_heading();
std::string function_rows(const Results& results);

// Of the generated code and all peers: times and ratios, their geometric means, and the peers that were not measured,
// with the reason. Empty when there is nothing to compare.
std::string comparison_table(const std::vector<Results>& robots);

}  // namespace robcogen::bench
