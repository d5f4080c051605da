// Spelling of scalar expressions: operators, signs and parentheses.
#pragma once

#include <string>

#include "symbolic/program.h"

namespace robcogen::backend {

enum class Precedence { sum, product, atom };

// A value `text`, or its negative. The sign stays apart from the text as long as it can: a sum turns it into an
// addition or a subtraction, a product moves it outwards.
struct Spelling {
  std::string text;
  Precedence precedence = Precedence::atom;
  bool negative = false;
  bool literal = false;
  std::string opposite;        // `b - a` where the text is `a - b`: the negative without a minus sign; else empty
  bool literal_first = false;  // the text begins with a literal that can take the sign, and `opposite` does so
};

// A number as a literal and its negative: `Scalar(0.35)`, `Scalar(-0.35)`.
Spelling literal(const std::string& text, const std::string& opposite);

// The operation in the evaluation order of the program: the operands of one addition or multiplication may change
// sides, nothing else.
Spelling binary(symbolic::Op op, Spelling a, Spelling b);

// A function of one value: `sqrt(x)`.
Spelling call(const std::string& function, const Spelling& argument);

// The value with its sign, as a whole expression.
std::string text(const Spelling& value);

}  // namespace robcogen::backend
