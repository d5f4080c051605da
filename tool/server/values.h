// The values of numbers in a document: degrees of angles in radians, and results of arithmetic.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/parsed.h"

namespace robcogen::server {

struct Value {
  Span span;  // of the expression
  bool is_angle = false;
  bool is_literal = false;  // a plain number
  Number number;
};

// Returns the values of all constant expressions, in the order of the text.
std::vector<Value> values_in(const Parsed& document);

// Returns the angle in degrees with six digits; exact for multiples of PI: `-90`, `22.5`.
std::string degrees_of(const Number& angle);

// Returns a text such as "`-PI/2.0` is -90°"; empty if there is nothing to report.
std::string describe(const Value& value, const Parsed& document);

}  // namespace robcogen::server
