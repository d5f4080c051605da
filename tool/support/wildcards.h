// Patterns of names: `*` stands for any number of characters, `?` for one. Every other character stands for itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robcogen {

bool has_wildcards(std::string_view pattern);

// Whether the pattern matches the whole text.
bool matches(std::string_view pattern, std::string_view text);

// The text that a misspelt pattern probably should match, or empty if none is near enough: the fewest edits, at most a
// third of the pattern's own characters, make the pattern match it. Among equally near ones, this is the first.
std::string nearest_to_pattern(const std::string& pattern, const std::vector<std::string>& texts);

}  // namespace robcogen
