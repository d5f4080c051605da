// C99 as a dialect: names and lines, in either precision.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"
#include "backend/cpp/layout.h"

namespace robcogen::backend::c {

using cpp::comment;
using cpp::quoted;

struct Precision {
  std::string scalar;    // the type
  std::string suffix;    // of names: of functions of <math.h> and of ours
  std::string file_end;  // of the name of a source
  bool is_float = false;
};

inline const Precision kDouble = {"double", "", ".c"}, kFloat = {"float", "f", "_f.c", true};
inline const std::vector<Precision> kPrecisions = {kDouble, kFloat};

// Where functions read a cache, parameters are elements of its array; otherwise members of their structure.
const Dialect& dialect(const Precision& precision, bool reads_cache);

// The members of the structure of parameters, by the names of all parameters.
std::vector<std::string> members(const std::vector<std::string>& parameters);

// A literal of any value; in single precision the nearest one, infinite beyond the largest.
std::string number(double value, const Precision& precision);

// `head(items)tail`, in several lines where one is too long.
std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail);

}  // namespace robcogen::backend::c
