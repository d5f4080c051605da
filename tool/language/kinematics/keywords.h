// Reserved words of the Kinematics-DSL.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robcogen::language::kinematics {

const std::vector<std::string>& keywords();
bool is_keyword(const std::string& word);
// The keyword of the joint type that `word` names in full, such as `u_joint` for `universal_joint`; empty if none does.
std::string_view keyword_of_joint(std::string_view word);

}  // namespace robcogen::language::kinematics
