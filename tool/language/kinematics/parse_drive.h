// Parses the items of a joint other than its frame: drive, limits, and the position in which loops are assembled. Their
// words are not reserved; they have this meaning only here.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// Whether the cursor is at the word of such an item.
bool at_drive_item(const Cursor& cursor);

// Parses the item after its word. Returns whether there was no error in it.
bool drive_item(BlockParser& parser, const std::string& owner, const Token& word, DriveAndLimits& items);

}  // namespace robcogen::language::kinematics
