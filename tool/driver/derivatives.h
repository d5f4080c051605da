// Derivatives of functions, as the user asks for them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/catalogue/transform_functions.h"
#include "driver/load.h"

namespace robcogen::driver {

// The group of these functions, for robots and for transforms. A library has them only if they are asked for.
inline constexpr const char* kDerivativesGroup = "derivatives";

// Parses `function:input` or `function:input,input`. Throws a Failure for any other text.
Derivative parse_derivative(const std::string& text);

// The functions with the derivatives that are asked for: `f_d_q_qd` has those of `f` by `q` and `qd`. It is in the
// scope of f, and there is one for each overload of f that takes these inputs. Its results are those of f, then for
// each input and each result a matrix with one row per element of the result (column by column) and one column per
// element of the input (symbolic/derivative.h). Throws a Failure that names `model` if the robot has no such function,
// if the function has no such input, or if the program would be too long to compile.
std::vector<algorithm::RobotFunction> derivative_functions(
    const Robot& robot,
    const std::filesystem::path& model,
    algorithm::FormulationChoices& formulations);

std::vector<algorithm::TransformFunction> derivative_functions(
    const Transforms& transforms,
    const std::filesystem::path& model);

}  // namespace robcogen::driver
