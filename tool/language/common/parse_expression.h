// Parses arithmetic in documents: from tokens to the tree of expression.h.
//
//     sum     = product (('+' | '-') product)*
//     product = unary (('*' | '/')? unary)*          with no operator: a name or `<constant>` after a number
//     unary   = ('-' | '+')* primary
//     primary = NUMBER | NAME ('[' NUMBER ']')? | NAME '.' NAME ('[' NUMBER ']')? | constant
//             | 'p' ':' NAME ('[' NUMBER ']')? | FUNCTION '(' sum ')' | '(' sum ')'
//     constant = '<' NAME ('=' NUMBER)? '>' | 'c' ':' NAME (':' NUMBER)? | 'consts' '.' NAME
//
// A name directly after a number multiplies it, with the precedence of `*`: `2.0 PI/3.0`, `0.5 len`, `2.0a`. The first
// RobCoGen read a signed name in the same way, and had no differences. Therefore an expression that consists only of
// `2.0 -PI`, with a blank before the sign and none after it, is that product, with a warning; `2.0 - PI`, `2.0-PI` and
// longer expressions subtract. A keyword is not a name: `Ix=0.5 Iy=0.3` are two items. A name before '=' or '{', and
// `a.b` before '=', are not names either: each is the word of an item, or a misspelt keyword.
#pragma once

#include "language/common/cursor.h"
#include "language/common/expression.h"

namespace robcogen::language {

// Parses an expression; the result is never null. Reports an error and throws SyntaxError if there is no expression, if
// it is nested too deeply or too long (later phases traverse the tree by recursion), and for `NaN` and `inf`, which are
// not names unless escaped.
ExpressionPtr parse_expression(Cursor& cursor);

}  // namespace robcogen::language
