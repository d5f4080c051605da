// What the names of corresponding things have in common.
#pragma once

#include <string>
#include <vector>

namespace robcogen::pass {

// `upperleg_wx` of LF_upperleg_wx, RF_upperleg_wx, …; `lanes` where they have nothing in common.
std::string common_name(const std::vector<std::string>& names);

// `link LF_foot, RF_foot: force` of `link LF_foot: force`, `link RF_foot: force`.
std::string common_title(const std::vector<std::string>& titles);

}  // namespace robcogen::pass
