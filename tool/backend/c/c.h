// C99: functions on arrays, in double and in single precision, that need only <math.h>.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend::c {

// The group that precedes the other groups of a robot.
inline constexpr const char* kParametersGroup = "parameters";

// The files of a library with these groups, as relative paths. They depend on the arguments alone. The prefix is the
// name of the library after its enclosing namespaces, `left_arm`.
std::vector<std::string> outputs(const std::string& prefix, const std::vector<std::string>& groups);

// Prints <prefix>_c/<group>.h, .c and _f.c for each group, model.h and model.c with names, limits and parameters, and
// <prefix>_c.h, which includes all headers. Functions are called <prefix>_<kernel>, with a final f in single precision.
// All arguments are arrays, results after inputs; matrices are stored column by column. If a robot has parameters, its
// functions take a structure first, which <prefix>_update of parameters.h computes from the parameters; the functions
// of transforms take the parameters themselves.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::c
