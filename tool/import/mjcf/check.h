// Finds misspelt attributes, which would otherwise be lost.
#pragma once

#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

// Warns about attributes of `compiler`, bodies, inertials and joints that MJCF does not have.
void check_attributes(const Element& root, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
