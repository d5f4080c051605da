// Spelling of scalar expressions: operators, signs and parentheses.
#pragma once

#include <string>
#include <string_view>

#include "support/texts.h"
#include "symbolic/program.h"

namespace robcogen::backend {

enum class Precedence { sum, product, atom };

// A value `text`, or its negative. The sign is kept apart from the text as long as possible: a sum turns it into an
// addition or a subtraction, a product moves it outwards. Refers to texts that must outlive it.
struct Spelling {
  std::string_view text;
  Precedence precedence = Precedence::atom;
  bool negative = false;
  bool literal = false;
  std::string_view opposite;   // `b - a` where the text is `a - b`: the negative without a minus sign, or empty
  int width = 1;               // lanes
  bool literal_first = false;  // the text begins with a literal that can take the sign, and `opposite` does so
};

// A number as a literal and its negative: `Scalar(0.35)`, `Scalar(-0.35)`.
Spelling literal(std::string_view text, std::string_view opposite);
// The same where the negative is the number with a sign in front.
Spelling literal(std::string_view number, Texts& texts);

// Spells the operation in the evaluation order of the program: only the operands of a single addition or multiplication
// may change sides.
Spelling binary(symbolic::Op op, Spelling a, Spelling b, Texts& texts);

// A call of a function of one value, `sqrt(x)`, or of two.
Spelling call(std::string_view function, const Spelling& argument, Texts& texts);
Spelling call(std::string_view function, const Spelling& first, const Spelling& second, Texts& texts);

// The value with its sign, as a whole expression.
std::string text(const Spelling& value);

}  // namespace robcogen::backend
