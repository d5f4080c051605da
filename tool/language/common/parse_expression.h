// Arithmetic in documents: tokens to the tree of expression.h.
//
//     sum     = product (('+' | '-') product)*
//     product = unary (('*' | '/')? unary)*          without a sign between: a name or `<constant>` after a number
//     unary   = ('-' | '+')* primary
//     primary = NUMBER | NAME ('[' NUMBER ']')? | NAME '.' NAME ('[' NUMBER ']')? | constant
//             | 'p' ':' NAME ('[' NUMBER ']')? | FUNCTION '(' sum ')' | '(' sum ')'
//     constant = '<' NAME ('=' NUMBER)? '>' | 'c' ':' NAME (':' NUMBER)? | 'consts' '.' NAME
//
// A name right after a number multiplies it, as strongly as `*`: `2.0 PI/3.0`, `0.5 len`, `2.0a`. The first RobCoGen
// read a signed name so too, and had no differences: an expression that is nothing but `2.0 -PI`, with a blank before
// the sign and none after it, is that product, and a warning says so; `2.0 - PI`, `2.0-PI` and longer expressions
// subtract. A keyword is no name: `Ix=0.5 Iy=0.3` are two items. Nor is a name before '=', which is a misspelt keyword.
#pragma once

#include "language/common/cursor.h"
#include "language/common/expression.h"

namespace robcogen::language {

// Never null. Throws SyntaxError, reported, where there is no expression; where it nests or goes on beyond all measure
// (what comes after may walk the tree by recursion); and for `NaN` and `inf`, which read like names and are none unless
// escaped.
ExpressionPtr parse_expression(Cursor& cursor);

}  // namespace robcogen::language
