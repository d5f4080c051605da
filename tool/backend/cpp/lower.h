// C++ as a dialect: how the lines of a kernel are spelled.
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

// Cuts the kernel into parts that are as long as possible without costing run time. Parts are short if the kernel has
// lanes, for the sake of registers, or if its code is larger than any processor's instruction cache, because the run
// time then grows with the size of the code.
Parts split(const Kernel& kernel);

// The lines of the program without stores; Kernel::results holds the outputs.
Kernel lower_values(const symbolic::Program& program);

// The name that kernels give to the type of values with lanes.
std::string type(int width);

// `Scalar(0.35)`; the value is not negative.
Spelling literal(double value, Texts& texts);

// The line without indentation, ready to be printed.
std::string text(const Line& line);

// The text between the braces of a function template over `Scalar`.
std::string body(const Kernel& kernel);

}  // namespace robcogen::backend::cpp
