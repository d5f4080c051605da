// C++ as a dialect: how the lines of a kernel are spelled.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "backend/common/lower.h"
#include "backend/common/split_kernel.h"

namespace robcogen::backend::cpp {

using backend::Kernel;
using backend::KernelArray;
using backend::Line;
using backend::LiveValues;
using backend::SplitKernel;

// The function of the runtime for arc tangents, in <robcogen/arc_tangent.h>.
inline constexpr const char* kArcTangent = "arc_tangent";
// For several of them, with its namespace.
inline constexpr const char* kArcTangents = "robcogen::arc_tangents_to";
// That for magnitudes, in <robcogen/magnitude.h>.
inline constexpr const char* kMagnitude = "magnitude";

const Dialect& dialect();

// Inputs, then outputs, under the names that they have in the kernel; all marked as used.
std::vector<KernelArray> parameters(const symbolic::Program& program);

Kernel lower(const symbolic::Program& program, const std::string& name);

// The kernel with sines in lanes that do not test for large angles. None if it has no such sines, or if it computes
// some sines in lanes together with others, which have no such version.
std::optional<Kernel> of_small_angles(Kernel kernel);

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
