// The items of a joint behind its frame: drive, limits, and where loops are assembled. Their words are not reserved:
// only there do they mean this.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// At the word of such an item.
bool at_drive_item(const Cursor& cursor);

// Reads the item behind its word. Returns whether there was no error in it.
bool drive_item(BlockParser& parser, const std::string& owner, const Token& word, DriveAndLimits& items);

}  // namespace robcogen::language::kinematics
