// Finds what the file says and nothing reads.
#pragma once

#include <map>

#include "import/sdf/document.h"

namespace robcogen::import::from_sdf {

// Warns about elements and attributes that SDF does not have, once for each name, where they could affect kinematics or
// dynamics, and about those that it has and that change forces or masses.
void check_names(const Element& root, Diagnostics& diagnostics);

// Counts the elements in `element` that have no effect, by name.
void count_ignored(const Element& element, std::map<std::string, int>& ignored);

}  // namespace robcogen::import::from_sdf
