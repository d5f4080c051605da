// Reads measurements back from a page of documentation.
#pragma once

#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// The robots of the last table in `page` that `markdown` (markdown.h) printed, with the medians of the generated code
// and those of the peers, computed from the ratios. Robots without a peer are left out. Throws std::runtime_error if
// the page has no such table, or a row of it cannot be read.
std::vector<Results> read_page(const std::string& page);

// The robots of the table `robot, DoF | inverse dynamics | …` of other generators, whose cells hold the time of the
// generated code and, in brackets, the ratio of each peer: `13.0 (8.0; 2.6)`. Throws as read_page does.
std::vector<Results> read_generators(const std::string& page, const std::vector<std::string>& peers);

}  // namespace robcogen::bench
