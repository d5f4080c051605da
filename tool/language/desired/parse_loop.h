// Parses the heads of loops over instances of parts: `for leg in { LF, RF } {`.
#pragma once

#include <string_view>

#include "language/desired/parse_frame.h"

namespace robcogen::language::desired {

// 'for' and 'in' are not reserved words: frames may have these names.
bool at_loop(const Cursor& cursor);

// The part of a loop before its body.
struct LoopHead {
  Loop loop;
  Token open;  // the opening brace of the body
};

// Reports an error if there is an enclosing loop `outer`. `element` tells what the body must contain.
LoopHead read_loop_head(Cursor& cursor, int outer, std::string_view element);

}  // namespace robcogen::language::desired
