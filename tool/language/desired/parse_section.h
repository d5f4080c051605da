// Parses the sections `Frames { … }`, `Transforms { … }`, `Jacobians { … }`, `Contacts { … }` and
// `InverseKinematics { … }` and `Functions { … }`.
#pragma once

#include "language/desired/parse_frame.h"

namespace robcogen::language::desired {

// Parses a section from its brace on; `word` is the word of kSections before it. Adds the content to the document.
void read_section(Cursor& cursor, const Token& word, Document& document);

}  // namespace robcogen::language::desired
