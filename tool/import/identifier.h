// Converts names of other formats to identifiers.
#pragma once

#include <string>

namespace robcogen::import {

// Returns the name with `_` in place of each character that an identifier cannot contain, and before a leading digit.
std::string identifier(const std::string& name);

}  // namespace robcogen::import
