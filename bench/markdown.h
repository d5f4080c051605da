// The report as tables for a page of documentation.
#pragma once

#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// Two tables with a row for each robot and compared quantity: one with the generated code's times, counts, bound and
// size, one with the ratios of the peers' times to these.
std::string markdown(const std::vector<Results>& robots);

}  // namespace robcogen::bench
