// Reserved words of the Kinematics-DSL.
#pragma once

#include <string>
#include <vector>

namespace robcogen::language::kinematics {

const std::vector<std::string>& keywords();
bool is_keyword(const std::string& word);

}  // namespace robcogen::language::kinematics
