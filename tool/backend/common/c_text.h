// Text with the same syntax in C and C++, in 120 columns: comments, strings, lists, and the first lines of a file.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend::c_family {

inline constexpr std::size_t kColumns = 120;

// Comment lines, wrapped at blanks. Characters that would end or continue a comment are replaced, and consecutive
// question marks are separated, because compilers warn about trigraphs.
std::string comment(const std::string& text, std::size_t indent = 0);
std::string comment(const std::vector<std::string>& texts);

// `{0.0, 1.0}`
std::string braced(const std::vector<std::string>& items);

// A string literal, without trigraphs.
std::string quoted(const std::string& text);

// The first lines of every file: what it is and which model it comes from. The model's hash stands in model.h only, so
// that a changed mass changes only the files whose numbers it changes.
std::string banner(const Library& library, const std::string& path, const std::string& what);

}  // namespace robcogen::backend::c_family
