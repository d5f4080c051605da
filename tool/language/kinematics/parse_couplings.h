// The block `couplings { … }` of robots and parts.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// From its word on. Adds them, and their comments, to the body.
void couplings(BlockParser& parser, Body& body);

}  // namespace robcogen::language::kinematics
