// The blocks `loops { … }`, `independent { … }` and `actuators { … }` of robots and parts.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// They are words only in front of their brace: elements may have these names.
bool at_loops(const Cursor& cursor);
bool at_actuators(const Cursor& cursor);
bool at_independent(const Cursor& cursor);

// From the word on. Adds what it contains, and its comments, to the body.
void loops(BlockParser& parser, Body& body);
void independent(BlockParser& parser, Body& body);
void actuators(BlockParser& parser, Body& body);

}  // namespace robcogen::language::kinematics
