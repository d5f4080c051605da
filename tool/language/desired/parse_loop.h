// Heads of loops over instances of parts: `for leg in { LF, RF } {`.
#pragma once

#include <string_view>

#include "language/desired/parse_frame.h"

namespace robcogen::language::desired {

// 'for' and 'in' are no reserved words: frames may have these names.
bool at_loop(const Cursor& cursor);

// What stands before the body of a loop.
struct LoopHead {
  Loop loop;
  Token open;  // the brace of the body
};

// `outer` is the loop that it stands in: there must be none. `element` says what the body must contain.
LoopHead read_loop_head(Cursor& cursor, int outer, std::string_view element);

}  // namespace robcogen::language::desired
