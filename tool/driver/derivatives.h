// Derivatives of functions, as the user asks for them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "driver/functions.h"

namespace robcogen::driver {

// The group of these functions, for robots and for transforms. A library has them only if they are asked for.
inline constexpr const char* kDerivativesGroup = "derivatives";

// Beyond this number, compilers take minutes for the code, which has no loops.
inline constexpr std::size_t kMaxExpressions = 200'000;

// Parses `function:input` or `function:input,input`, or `all`: a Derivative without inputs. Throws a Failure for any
// other text.
Derivative parse_derivative(const std::string& text, symbolic::DerivativeForm form = symbolic::DerivativeForm::matrix);

// The functions with the derivatives that are asked for: `f_d_q_qd` has those of `f` by `q` and `qd` as matrices,
// `f_gradient_q_qd` the gradients of a weighted sum of its results, `f_tangent_q_qd` the rates of its results for given
// rates of q and qd. It is in the scope of f, and there is one for each overload of f that takes these inputs. Its
// results are those of f, then the derivatives (symbolic/derivative.h). f may be one of these functions itself. Throws
// a Failure that names `model` if the robot has no such function, or if the function has no such input.
// `all` stands for those of `functions` that have no derivatives yet, neither in the list nor among their results,
// each by the inputs of its overload with the fewest, except parameters and switches; functions of an inertia factor
// and inverse kinematics are left out.
std::vector<Function> derivative_functions(
    const Robot& robot,
    const std::vector<Function>& functions,
    const std::filesystem::path& model);

// The same for transforms.
std::vector<symbolic::Function> derivative_functions(
    const Transforms& transforms,
    const std::vector<Function>& functions,
    const std::filesystem::path& model);

// A function that was traced with these choices, with its derivatives. Throws a Failure if the program would be too
// long to compile.
symbolic::Function differentiated(
    symbolic::Function function,
    const Derivative& derivative,
    const algorithm::Declared& declared,
    const algorithm::FormulationChoices& choices);

// A declared function by its names.
Function function_of(algorithm::Declared declared, std::vector<Derivative> derivatives_in_turn = {});

}  // namespace robcogen::driver
