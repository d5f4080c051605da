// What the numbers of a document are: degrees of angles in radians, results of arithmetic.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/parsed.h"

namespace robcogen::server {

struct Value {
  Span span;  // of the expression
  bool is_angle = false;
  bool is_literal = false;  // a number as it is
  Number number;
};

// Of all expressions that are constant, in the order of the text.
std::vector<Value> values_in(const Parsed& document);

// Exact for multiples of PI: `-90`, `22.5`; else six digits.
std::string degrees_of(const Number& angle);

// `-PI/2.0` is -90°; empty where there is nothing to say.
std::string describe(const Value& value, const Parsed& document);

}  // namespace robcogen::server
