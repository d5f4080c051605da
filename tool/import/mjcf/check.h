// Finds misspelt attributes, which would otherwise be lost.
#pragma once

#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

// Warns about attributes that MJCF does not have: of `compiler`, `option`, bodies and what they contain, and equalities
// of joints.
void check_attributes(const Element& root, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
