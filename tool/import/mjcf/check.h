// Finds what the model says and nothing reads, which would otherwise be lost.
#pragma once

#include "import/mjcf/element.h"

namespace robcogen::import::from_mjcf {

// Warns about elements and attributes that MJCF does not have, once for each name, where they could affect kinematics
// or dynamics: not in sensors, visuals and the like.
void check_names(const Element& root, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_mjcf
