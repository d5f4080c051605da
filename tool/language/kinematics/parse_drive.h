// The items of a joint behind its frame: drive, limits, and where loops are assembled. Their words are not reserved:
// only there do they mean this.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// At the word of such an item.
bool at_drive_item(const Cursor& cursor);

// Where they are read to: of a joint, or of one of its coordinates.
struct DriveItems {
  Drive& drive;
  std::optional<Rotor>& rotor;
  Limits& limits;
  ExpressionPtr& assembled;
};

// Reads the item behind its word. Returns whether there was no error in it.
bool drive_item(BlockParser& parser, const std::string& owner, const Token& word, const DriveItems& items);

}  // namespace robcogen::language::kinematics
