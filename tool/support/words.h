// Lists of names that are written as one text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robcogen {

// The words of a text, split at blanks.
std::vector<std::string> words(std::string_view text);

bool is_among(const std::vector<std::string>& names, const std::string& name);

}  // namespace robcogen
