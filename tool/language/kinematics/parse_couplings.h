// Parses the block `couplings { … }` of robots and parts.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// Parses the block from its word on, and adds the couplings and their comments to the body.
void couplings(BlockParser& parser, Body& body);

}  // namespace robcogen::language::kinematics
