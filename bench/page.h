// Measurements on a page of documentation, read back from it.
#pragma once

#include <string>
#include <vector>

#include "results.h"

namespace robcogen::bench {

// The robots of the last table of `markdown` (markdown.h) in `page`: medians of the generated code, and of the peers as
// ratio times these. Robots without a peer are left out. Throws std::runtime_error where the page has no such table, or
// a row of it cannot be read.
std::vector<Results> read_page(const std::string& page);

}  // namespace robcogen::bench
