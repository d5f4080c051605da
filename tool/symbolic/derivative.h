// Partial derivatives of programs, as programs: each statement is differentiated by itself (Griewank and Walther 2008,
// ch. 3), and what folds or is there already costs nothing.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "symbolic/expression.h"
#include "symbolic/program.h"

namespace robcogen::symbolic {

// An output of a program that is the derivative of another one by an input: a row for each element of the latter,
// column by column, a column for each of the input.
struct DerivativeBlock {
  int of = 0;  // outputs
  std::string by;
  int place = 0;
};

// Of an expression of few operations, by an input.
Expression derivative(const Expression& of, const Expression& by);

// An expression that changes at this rate, whatever it depends on.
struct Rate {
  Expression of, rate;
};

// The rates of expressions of one graph where these change, and no other input does: forward mode (Griewank and Walther
// 2008, sec. 3.1).
std::vector<Expression> rates_of(const std::vector<Expression>& of, const std::vector<Rate>& changes);

// `cheaper`: forward mode, or reverse mode (an adjoint for each element of the outputs), whichever takes less work
// (count.h).
enum class DerivativeMode { forward, cheaper };

// The program, with the derivatives of its outputs by each element of these inputs as further outputs. Those of `y` by
// `q` are the array `y_d_q`, or `d_q` where the program has one output that is not called so itself: a row for each
// element of y, a column for each of q. Of programs without lanes.
// In place of the four columns of a unit quaternion stand three, by a turn (rad) about each axis of the frame that it
// turns. Elements that follow others (InputArray::followers) have no columns: they move as these have them.
Program with_derivatives(const Program& program, const std::vector<std::string>& inputs);

// How elements of an input that follow others do: a program of inputs of those that it is for. Its output is a matrix
// with a row for each of them, and a column for each other derivative by the input. Of none: nullopt.
using FollowerRates = std::optional<Program>;

// The same in this mode; in the other one where that would take more than `most` expressions. nullopt where both would.
std::optional<Program> with_derivatives(
    const Program& program,
    const std::vector<std::string>& inputs,
    DerivativeMode mode,
    std::size_t most,
    const FollowerRates& rates = {});

// Reverse mode: the program, with the gradient of the product of `weights` and the elements of these outputs, one after
// the other. Weights are a further input, in front of the input array `place`. The derivatives by an input `q` are the
// array `d_q`. Costs a small multiple of the program, however many inputs there are. Unit quaternions and followers as
// above.
Program with_gradient(
    const Program& program,
    const std::vector<std::string>& outputs,
    const std::vector<std::string>& inputs,
    std::size_t place,
    const FollowerRates& rates = {});

// Derivatives of the `d_x` of such a gradient by y, for each pair (x, y): `d_x_y`, symmetric where x is y.
Program with_second_derivatives(
    const Program& gradient,
    const std::vector<std::pair<std::string, std::string>>& pairs,
    DerivativeMode mode,
    const FollowerRates& rates = {});

}  // namespace robcogen::symbolic
