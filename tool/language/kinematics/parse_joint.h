// Parses the elements `r_joint`, `p_joint` and the other types of joints, of robots and parts.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// Parses a joint from its keyword on, and adds it to the body unless there is an error in it.
void joint(BlockParser& parser, Body& body);

}  // namespace robcogen::language::kinematics
