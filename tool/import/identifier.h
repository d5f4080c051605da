// Names of other formats as identifiers.
#pragma once

#include <string>

namespace robcogen::import {

// The name with `_` instead of each character that an identifier cannot have, and before a digit at its beginning.
std::string identifier(const std::string& name);

}  // namespace robcogen::import
