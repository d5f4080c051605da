// Derivatives of functions that the user asks for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/catalogue/transform_functions.h"
#include "driver/load.h"

namespace robcogen::driver {

// The group of these functions, of robots and of transforms. No robot has them unless they are asked for.
inline constexpr const char* kDerivativesGroup = "derivatives";

// `function:input`, `function:input,input`. A Failure for any other text.
Derivative parse_derivative(const std::string& text);

// The functions with the derivatives that are asked for: `f_d_q_qd` for those of `f` by `q` and `qd`, in the scope of
// f, each overload of f that takes these inputs. Results of f, then for each input, of each of them, a matrix with a
// row for each element of the result (column by column) and a column for each of the input (symbolic/derivative.h).
// Throws a Failure, which names `model`, if the robot has no such function, the function no such input, or the program
// would be too long to compile.
std::vector<algorithm::RobotFunction> derivative_functions(
    const Robot& robot,
    const std::filesystem::path& model,
    algorithm::FormulationChoices& formulations);

std::vector<algorithm::TransformFunction> derivative_functions(
    const Transforms& transforms,
    const std::filesystem::path& model);

}  // namespace robcogen::driver
