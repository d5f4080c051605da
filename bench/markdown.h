// The report as tables for a page of documentation.
#pragma once

#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// Two tables with a row for each robot and compared quantity: the generated code's times, counts, bound and size; and
// how many times as long each peer takes.
std::string markdown(const std::vector<Results>& robots);

}  // namespace robcogen::bench
