// The report as text for a console.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// Of the generated functions: time, operation counts, and bytes of the kernels; `sizes` may lack some.
std::string function_heading();
std::string function_rows(const Results& results, const std::map<std::string, long>& sizes);

// Of the generated code and all peers: times and ratios, their geometric means, and who was not measured and why. Empty
// when there is nothing to compare.
std::string comparison_table(const std::vector<Results>& robots);

}  // namespace robcogen::bench
