// Converts names of other formats to identifiers.
#pragma once

#include <string>

namespace robcogen::import {

// Returns the name (UTF-8) with `u` and the code point in place of each character beyond ASCII, in at least four
// hexadecimal digits (`u5DE6`), and `_` in place of every other character that an identifier cannot contain, and before
// a leading digit. Two names can become equal.
std::string identifier(const std::string& name);

// Whether the name has characters beyond ASCII.
bool is_beyond_ascii(const std::string& name);

}  // namespace robcogen::import
