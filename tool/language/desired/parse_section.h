// The sections `Frames { … }`, `Transforms { … }`, `Jacobians { … }` and `Contacts { … }`.
#pragma once

#include "language/desired/parse_frame.h"

namespace robcogen::language::desired {

// From the brace on; `word` is the one before it, of kSections. Adds what the section contains to the document.
void read_section(Cursor& cursor, const Token& word, Document& document);

}  // namespace robcogen::language::desired
