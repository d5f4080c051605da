// C++ as a dialect: how a kernel's lines are spelt.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"

namespace robcogen::backend::cpp {

using backend::Kernel;
using backend::Line;
using backend::Parameter;

const Dialect& dialect();

// Inputs, then outputs, under the names that they have in the kernel; all marked as used.
std::vector<Parameter> parameters(const symbolic::Program& program);

Kernel lower(const symbolic::Program& program, const std::string& name);

// The program's lines without stores: what its outputs are stands in Kernel::results.
Kernel lower_values(const symbolic::Program& program);

// The type of values with lanes, as kernels call it.
std::string type(int width);

// `Scalar(0.35)`; the value is not negative.
Spelling literal(double value);

// The line without indentation, ready to be printed.
std::string text(const Line& line);

}  // namespace robcogen::backend::cpp
