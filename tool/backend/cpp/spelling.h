// Spelling of scalar expressions: operators, signs and parentheses.
#pragma once

#include <string>

#include "symbolic/program.h"

namespace robcogen::backend::cpp {

enum class Precedence { sum, product, atom };

// A value `text`, or its negative. The sign stays apart from the text as long as it can: a sum turns it into an
// addition or a subtraction, a product moves it outwards.
struct Spelling {
  std::string text;
  Precedence precedence = Precedence::atom;
  bool negative = false;
  bool literal = false;
  std::string opposite;  // `b - a` where the text is `a - b`: the negative without a minus sign; else empty
};

// `Scalar(0.35)`; the value is not negative.
Spelling literal(double value);

// The operation in the evaluation order of the program: the operands of one addition or multiplication may change
// sides, nothing else.
Spelling binary(symbolic::Op op, Spelling a, Spelling b);

// A function of one value: `sqrt(x)`.
Spelling call(const std::string& function, const Spelling& argument);

// The value with its sign, as a whole expression.
std::string text(const Spelling& value);

}  // namespace robcogen::backend::cpp
