// Regular expressions (of ECMAScript) in tests. They are here because std::regex takes three seconds to compile in each
// file that uses it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace robcogen::test {

// What a pattern found, and its groups from 1; a group that took no part is empty.
using Match = std::vector<std::string>;

// The match of the whole text.
std::optional<Match> whole_match(const std::string& text, const std::string& pattern);

// The first match in the text.
std::optional<Match> first_match(const std::string& text, const std::string& pattern);

std::vector<Match> all_matches(const std::string& text, const std::string& pattern);

// The text with each match replaced.
std::string replaced(const std::string& text, const std::string& pattern, const std::string& by);

}  // namespace robcogen::test
