// C99 as a dialect: names and lines, in either precision.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"

namespace robcogen::backend::c {

struct Precision {
  std::string scalar;  // the type
  std::string suffix;  // of names: of functions of <math.h> and of ours
};

inline const Precision kDouble = {"double", ""}, kFloat = {"float", "f"};
inline const std::vector<Precision> kPrecisions = {kDouble, kFloat};

// Where functions read a cache, parameters are elements of its array; otherwise members of their structure.
const Dialect& dialect(const Precision& precision, bool reads_cache);

// The members of the structure of parameters, by the names of all parameters.
std::vector<std::string> members(const std::vector<std::string>& parameters);

// Keywords of C and C++, since headers are for both, and macros of system headers.
bool is_reserved(const std::string& name);

// A literal of any value; in single precision the nearest one, infinite beyond the largest.
std::string number(double value, const Precision& precision);

// As in C++, and without trigraphs.
std::string comment(const std::string& text, std::size_t indent = 0);
std::string quoted(const std::string& text);

// `head(items)tail`, in several lines where one is too long.
std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail);

}  // namespace robcogen::backend::c
