// Common names for corresponding links and joints of congruent limbs, and common titles of their sections.
#pragma once

#include <string>
#include <vector>

namespace robcogen::symbolic {

// `hipassembly` for LF_hipassembly, RF_hipassembly, …: the words that all names share; empty if there are none.
std::string common_words(const std::vector<std::string>& names);

// The same, but `lanes` if the names have nothing in common.
std::string common_name(const std::vector<std::string>& names);

// `link foot of LF, RF: force` for `link LF_foot: force`, `link RF_foot: force`.
std::string common_title(const std::vector<std::string>& titles);

}  // namespace robcogen::symbolic
