// Common names for corresponding values of congruent limbs.
#pragma once

#include <string>
#include <vector>

namespace robcogen::symbolic {

// `upperleg_wx` for LF_upperleg_wx, RF_upperleg_wx_neg, …; `lanes` if the names have nothing in common.
std::string common_name(const std::vector<std::string>& names);

// `link foot of LF, RF: force` for `link LF_foot: force`, `link RF_foot: force`.
std::string common_title(const std::vector<std::string>& titles);

// `hip_wx` for `hip_wx_neg`.
std::string without_sign(const std::string& name);

}  // namespace robcogen::symbolic
