// The elements `link` and `RobotBase` of robots and parts.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// From its keyword on. Adds the link to the body. `part`, or null: whose link this is.
void link(BlockParser& parser, Body& body, const Part* part);

}  // namespace robcogen::language::kinematics
