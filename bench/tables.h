// The report as text for a console.
#pragma once

#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// The table of generated functions: times, operation counts, the lower bound of a call, and bytes of the kernels; a
// line about the robot comes before its functions.
std::string function_heading();
std::string function_rows(const Results& results);

// The table of the generated code and all peers: times and ratios, their geometric means, and the peers that were not
// measured, with the reason. Empty if there is nothing to compare.
std::string comparison_table(const std::vector<Results>& robots);

}  // namespace robcogen::bench
