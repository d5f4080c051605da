// C99: functions on arrays, in double and in single precision, that need <math.h> and nothing else.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend::c {

// In front of the groups of a robot.
inline constexpr const char* kParametersGroup = "parameters";

// The files of a library with these groups, relative. They follow from the arguments alone. The prefix is the name
// after the enclosing namespaces, `left_arm`.
std::vector<std::string> outputs(const std::string& prefix, const std::vector<std::string>& groups);

// <prefix>_c/<group>.h, .c and _f.c for each group, model.h and model.c with names, limits and parameters, and
// <prefix>_c.h, which includes all headers. Functions are <prefix>_<kernel>, in single precision with an f behind. All
// arguments are arrays, results behind inputs; matrices column by column. Functions of a robot with parameters take a
// structure first that <prefix>_update of parameters.h computes of the parameters; those of transforms, the parameters.
std::vector<OutputFile> print(const Library& library);

}  // namespace robcogen::backend::c
