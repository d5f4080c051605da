// C99 as a dialect: names and lines, in either precision.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"

namespace robcogen::backend::c {

enum class Precision { in_double, in_float };

const Dialect& dialect(Precision precision);

// `double` or `float`.
std::string scalar(Precision precision);

// Keywords of C and C++, since headers are for both, and macros of system headers.
bool is_reserved(const std::string& name);

// A literal of any finite value; in single precision the nearest one, infinite beyond the largest.
std::string number(double value, Precision precision);

// As in C++, and without trigraphs.
std::string comment(const std::string& text, std::size_t indent = 0);
std::string quoted(const std::string& text);

// `head(items)tail`, in several lines where one is too long.
std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail);

}  // namespace robcogen::backend::c
