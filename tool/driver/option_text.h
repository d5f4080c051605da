// The text of options as a source, so that messages can show places in it.
#pragma once

#include <string>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::driver {

// The places of an option's words. Its text is a source of its own.
std::vector<Place> places_of(const std::string& option, const std::vector<std::string>& words);

}  // namespace robcogen::driver
