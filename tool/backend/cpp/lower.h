// C++ as a dialect: how a kernel's lines are spelt.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"
#include "backend/common/parts.h"

namespace robcogen::backend::cpp {

using backend::Handed;
using backend::Kernel;
using backend::Line;
using backend::Parameter;
using backend::Parts;

const Dialect& dialect();

// Inputs, then outputs, under the names that they have in the kernel; all marked as used.
std::vector<Parameter> parameters(const symbolic::Program& program);

Kernel lower(const symbolic::Program& program, const std::string& name);

// Whether the kernel is cut into parts.
bool is_split(const Kernel& kernel);

// In parts as long as costs no time when they run; and short ones, for the sake of registers, where there are lanes, or
// where the code is larger than the instruction cache of any processor, so that time goes with its size.
Parts split(const Kernel& kernel);

// The program's lines without stores: what its outputs are stands in Kernel::results.
Kernel lower_values(const symbolic::Program& program);

// The type of values with lanes, as kernels call it.
std::string type(int width);

// `Scalar(0.35)`; the value is not negative.
Spelling literal(double value, Texts& texts);

// The line without indentation, ready to be printed.
std::string text(const Line& line);

// What stands between the braces of a function template over `Scalar`.
std::string body(const Kernel& kernel);

}  // namespace robcogen::backend::cpp
