// Parses the blocks `loops { … }`, `independent { … }`, `actuators { … }` and `tendons { … }` of robots and parts.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// These words are special only before their brace: elements may have these names.
bool at_loops(const Cursor& cursor);
bool at_actuators(const Cursor& cursor);
bool at_independent(const Cursor& cursor);
bool at_tendons(const Cursor& cursor);

// Parse a block from its word on, and add its content and comments to the body.
void loops(BlockParser& parser, Body& body);
void independent(BlockParser& parser, Body& body);
void actuators(BlockParser& parser, Body& body);
void tendons(BlockParser& parser, Body& body);

}  // namespace robcogen::language::kinematics
