// Parses named values other than plain names: the constants and parameters of the grammar in parse_expression.h.
#pragma once

#include "language/common/cursor.h"
#include "language/common/expression.h"

namespace robcogen::language {

// Parses `<name=3.2>`, `<name>`, `c:name:1.5`, `c:name`, `p:name[1.5]` or `group.name[1.5]`; returns null if none of
// them begins here. Reports an error and throws SyntaxError if one begins but does not continue correctly.
ExpressionPtr parse_named_value(Cursor& cursor);

// Parses `[1.5]`, the default value of the parameter, whose span then includes it. Returns whether there is one.
bool accept_default(Cursor& cursor, Expression& parameter);

}  // namespace robcogen::language
