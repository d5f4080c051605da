// Imports, the heads of parts, and parts that are attached to links.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// `import`, where a robot document begins: not a keyword.
Import import_of(BlockParser& parser);

// `Part Leg`: elsewhere `Part` is a name.
bool at_part(const Cursor& cursor);
// Up to the brace: `Part Leg(thigh[0.35], shank)`.
Part part_head(BlockParser& parser);
// `root hip via HAA` in a part.
bool at_root(const Cursor& cursor);
Child root(BlockParser& parser);

// `Leg LF(…)` or `Leg LF at { … }`, and what follows: a child of a link begins with `name via`.
bool at_instance(const Cursor& cursor);
Instance instance(BlockParser& parser);

}  // namespace robcogen::language::kinematics
