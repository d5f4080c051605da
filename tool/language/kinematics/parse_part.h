// Parses imports, the heads of parts, and parts that are attached to links.
#pragma once

#include "language/kinematics/block_parser.h"

namespace robcogen::language::kinematics {

// Parses an import. `import` is not a keyword; it is special only at the beginning of a robot document.
Import import_of(BlockParser& parser);

// Whether the cursor is at `Part Leg`; elsewhere `Part` is a name.
bool at_part(const Cursor& cursor);
// Parses the head of a part, up to the brace: `Part Leg(thigh[0.35], shank)`.
Part part_head(BlockParser& parser);
// Whether the cursor is at a root, as in `root hip via HAA`, in a part.
bool at_root(const Cursor& cursor);
Child root(BlockParser& parser);

// Whether the cursor is at `Leg LF(…)` or `Leg LF at { … }`; other children of a link begin with `name via`.
bool at_instance(const Cursor& cursor);
Instance instance(BlockParser& parser);

}  // namespace robcogen::language::kinematics
