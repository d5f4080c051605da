// What the arrays of functions are, for their documentation.
#pragma once

#include <string>

#include "symbolic/program.h"

namespace robcogen::backend {

// The quantity, its unit and its frame; empty where the summary of the function says it, and for parameters and the
// wrenches on links, whose shape differs between languages.
std::string meaning(symbolic::Role role);

// What the elements of q are where some of them are quaternions; else empty.
std::string remark_on_quaternions(const symbolic::Program& program);

// Whether the elements are those of the joints, in the order of the model.
bool is_of_joints(symbolic::Role role);

}  // namespace robcogen::backend
