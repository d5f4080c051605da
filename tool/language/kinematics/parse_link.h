// Parses the elements `link` and `RobotBase` of robots and parts.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// Parses a link from its keyword on, and adds it to the body. `part` is the part to which the link belongs, or null.
void link(BlockParser& parser, Body& body, const Part* part);

}  // namespace robcogen::language::kinematics
