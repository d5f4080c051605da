// What the first RobCoGen reads.
#pragma once

#include "language/kinematics/document.h"

namespace robcogen::language::kinematics {

// Reports what the first RobCoGen would not read of the canonical text of a document. Returns whether it reads all.
bool is_original(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::language::kinematics
