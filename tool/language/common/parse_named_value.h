// Values that have a name other than a plain one: the constants and parameters of the grammar in parse_expression.h.
#pragma once

#include "language/common/cursor.h"
#include "language/common/expression.h"

namespace robcogen::language {

// `<name=3.2>`, `<name>`, `c:name:1.5`, `c:name`, `p:name[1.5]`, `group.name[1.5]`; null where none of them begins
// here. Throws SyntaxError, after reporting it, where one begins and does not go on as it must.
ExpressionPtr parse_named_value(Cursor& cursor);

// Whether `[1.5]` stands here: the default of the parameter, whose span then includes it.
bool accept_default(Cursor& cursor, Expression& parameter);

}  // namespace robcogen::language
