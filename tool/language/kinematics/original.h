// Checks which documents the first RobCoGen can read.
#pragma once

#include "language/kinematics/document.h"

namespace robcogen::language::kinematics {

// Reports what the first RobCoGen would not read in the canonical text of a document. Returns whether it can read
// everything.
bool is_original(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::language::kinematics
