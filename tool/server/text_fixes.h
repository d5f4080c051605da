// Quick fixes that correct the notation.
#pragma once

#include <vector>

#include "server/quick_fixes.h"

namespace robcogen::server {

// Corrects decimal commas, superfluous commas and semicolons, numbers that run into names, products with signs, angles
// in degrees, ids of links, the dialect of 2011, and moments of inertia about the centre of mass.
void add_text_fixes(const Diagnostic& diagnostic, const Place& place, std::vector<QuickFix>& fixes);

}  // namespace robcogen::server
