// Partial derivatives of programs, as programs: each statement is differentiated by itself (Griewank and Walther 2008,
// ch. 3). Derivatives that fold or exist already cost nothing.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "symbolic/expression.h"
#include "symbolic/program.h"

namespace robcogen::symbolic {

// Which numbers of the matrix J of partial derivatives of some results by some inputs: all of them, its product with
// weights of the results (the gradient J^T w, by reverse mode), or with rates of the inputs (the tangent J t).
enum class DerivativeForm { matrix, gradient, tangent };

// The output `place` of a program is the derivative of `results` outputs, `of` and the next ones, by the input `by`. As
// a matrix, it has a row for each element of the output (column by column) and a column for each element of the input.
// In the other forms, J is multiplied by the input `vector`; there may be several vectors for several outputs, which
// follow each other.
struct DerivativeBlock {
  int of = 0;  // index into the outputs, as is `place`
  std::string by;
  int place = 0;
  DerivativeForm form = DerivativeForm::matrix;
  std::string vector = {};
  int results = 1;
};

// Programs that know how the base is oriented have derivatives by this too, as if it were an input: three columns, for
// small rotations (rad) of the base about its own axes. Gravity is fixed in the world, so that the input of this role,
// in base coordinates, becomes gravity - turn x gravity. Velocities and accelerations of the base, in base coordinates,
// stay the same.
inline constexpr const char* kBaseRotation = "base_rotation";

// The input from which a program knows how the base is oriented: gravity, or the pose of the base; null if there is
// none.
const InputArray* orientation_of_base(const Program& program);

// The derivative of an expression of few operations by an input.
Expression derivative(const Expression& of, const Expression& by);

// An expression that is given this rate, whatever it depends on.
struct Rate {
  Expression of, rate;
};

// The rates of expressions of one graph when `changes` are given and no other input changes, by forward mode (Griewank
// and Walther 2008, sec. 3.1).
std::vector<Expression> rates_of(const std::vector<Expression>& of, const std::vector<Rate>& changes);

// `cheaper`: forward mode, or reverse mode (an adjoint for each element of the outputs), whichever takes less work
// (cost.h).
enum class DerivativeMode { forward, cheaper };

// Returns the program with the derivatives of its outputs by each element of these inputs as further outputs. The
// derivative of `y` by `q` is the array `y_d_q`, or `d_q` if the program has only one output and that is not called
// `d_q`: a row for each element of y, a column for each element of q. The program must not have lanes.
// A unit quaternion has three columns instead of four, by a rotation (rad) about each axis of the rotated frame.
// Elements that follow others (InputArray::followers) have no columns: they move with the elements that they follow.
// `inputs` may contain kBaseRotation if orientation_of_base(program) is an input.
Program with_derivatives(const Program& program, const std::vector<std::string>& inputs);

// How the followers among the elements of an input depend on the others: a program whose inputs are inputs of the
// program to differentiate. Its output is a matrix with a row for each follower and a column for each other derivative
// by the input. nullopt if there are no followers.
using FollowerRates = std::optional<Program>;

// The same in this mode, or in the other one if this one takes more than `most` expressions; nullopt if both do.
std::optional<Program> with_derivatives(
    const Program& program,
    const std::vector<std::string>& inputs,
    DerivativeMode mode,
    std::size_t most,
    const FollowerRates& rates = {});

// An input of weights: one for each element of these outputs, in their order.
struct WeightedOutputs {
  std::string name;
  std::vector<std::string> outputs;
};

// In front of gravity and external wrenches, where functions take further inputs.
std::size_t place_of_loads(const Program& program);

// One for each output: `weights`, or `y_weights` for an output `y` among several.
std::vector<WeightedOutputs> weights_of_outputs(const Program& program);

// Returns the program with the gradient of the weighted sum of all elements of the outputs, by reverse mode. The
// weights are further inputs in front of the input array `place`. The derivatives by an input `q` are the array `d_q`.
// The gradient costs a small multiple of the program, however many inputs there are. Unit quaternions, followers and
// kBaseRotation are treated as above.
Program with_gradient(
    const Program& program,
    const std::vector<WeightedOutputs>& weights,
    const std::vector<std::string>& inputs,
    std::size_t place,
    const FollowerRates& rates = {});

// Returns the program with the rates of its outputs when these inputs change at given rates, by forward mode: for each
// output `y` the array `y_tangent`. The rates of an input `q` are a further input `q_tangent` in front of the input
// array `place`, with an element for each column of the derivatives by q above. The tangent costs a small multiple of
// the program.
Program with_tangents(
    const Program& program,
    const std::vector<std::string>& inputs,
    std::size_t place,
    const FollowerRates& rates = {});

// The names of the outputs that these functions add: of tangents, of gradients by an input, and of derivatives of one
// of `results` outputs by an input.
std::string name_of_tangent(const std::string& array);
std::string name_of_gradient(const std::string& input);
std::string name_of_block(std::size_t results, const std::string& of, const std::string& input);

// Returns such a gradient with the derivatives of its arrays `d_x` by y as further outputs `d_x_y`, for each pair
// (x, y). They are symmetric if x is y and has no quaternions.
Program with_second_derivatives(
    const Program& gradient,
    const std::vector<std::pair<std::string, std::string>>& pairs,
    DerivativeMode mode,
    const FollowerRates& rates = {});

}  // namespace robcogen::symbolic
