// Reserved words of the desired-transforms language.
#pragma once

#include <string>
#include <vector>

namespace robcogen::language::desired {

const std::vector<std::string>& keywords();
bool is_keyword(const std::string& word);

}  // namespace robcogen::language::desired
