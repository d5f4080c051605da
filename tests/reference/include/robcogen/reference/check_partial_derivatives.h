// Checks of derivatives that a user asked for, against differences of the function's own results.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "robcogen/reference/checks.h"
#include "robcogen/reflection.h"

namespace robcogen::reference {

inline constexpr Tolerance kPartial{
    "kPartial", 1e-7, "a fourth-order difference of 2e-4 in double, where one of half the step agrees"};

// The results of the function and of its derivatives, after a step of one element of an input.
using Moved = std::function<std::vector<double>(int element, double step)>;

// The derivative of results `value` to `value + rows` with respect to one element.
inline std::vector<double> difference_of(
    const Moved& moved,
    const reflection::Derivative& d,
    int element,
    double step) {
  const std::vector<double> a = moved(element, step), b = moved(element, -step), c = moved(element, 2 * step),
                            e = moved(element, -2 * step);
  std::vector<double> result;
  for (int r = 0; r < d.rows; ++r) {
    const auto i = static_cast<std::size_t>(d.value + r);
    result.push_back((8 * (a[i] - b[i]) - (c[i] - e[i])) / (12 * step));
  }
  return result;
}

// The largest error of a block, relative to its largest element and the largest result; NaN if no difference converges,
// as near a pole, or in friction near zero velocity.
inline Real error_of(const reflection::Derivative& d, const Moved& moved) {
  constexpr double kStep = 2e-4, kConverged = 1e-8;
  Real largest = 0, error = std::numeric_limits<Real>::quiet_NaN();
  const auto meet = [&](double x) { largest = std::max(largest, std::abs(static_cast<Real>(x))); };
  const std::vector<double> here = moved(0, 0);
  for (int r = 0; r < d.rows; ++r) meet(here[static_cast<std::size_t>(d.value + r)]);
  for (int k = 0; k < d.rows * d.columns; ++k) meet(here[static_cast<std::size_t>(d.place + k)]);
  if (!std::isfinite(largest)) return error;
  largest = std::max(largest, static_cast<Real>(kConverged));
  for (int column = 0; column < d.columns; ++column) {
    const std::vector<double> whole = difference_of(moved, d, column, kStep);
    const std::vector<double> half = difference_of(moved, d, column, kStep / 2);
    for (int r = 0; r < d.rows; ++r) {
      const auto i = static_cast<std::size_t>(r);
      if (!(std::abs(whole[i] - half[i]) < kConverged * largest)) continue;
      const double found = here[static_cast<std::size_t>(d.place + column * d.rows + r)];
      const Real difference = std::abs(static_cast<Real>(found) - static_cast<Real>(half[i])) / largest;
      error = std::isnan(error) ? difference : std::max(error, difference);
    }
  }
  return error;
}

// Moves the inputs by a step of the variable of one column of the derivative. For positions of spherical joints that is
// a rotation.
using MoveInputs = std::function<void(
    const reflection::Function&,
    const reflection::Derivative&,
    int element,
    double step,
    std::vector<double>& inputs)>;

inline void move_number(
    const reflection::Function&,
    const reflection::Derivative& d,
    int element,
    double step,
    std::vector<double>& inputs) {
  inputs[static_cast<std::size_t>(d.input + element)] += step;
}

// Rotates the base by a step about one of its axes, or moves its position: `inputs` at d.input are gravity in base
// coordinates, or the pose of the base, whose quaternion need not be of unit length.
inline void move_base(const reflection::Derivative& d, int element, double step, std::vector<double>& inputs) {
  double* at = inputs.data() + d.input;
  if (element > 2) {
    at[element + 1] += step;
    return;
  }
  const int x = element, y = (x + 1) % 3, z = (x + 2) % 3;
  if (d.variation == reflection::Variation::of_gravity_in_base) {
    const double c = std::cos(step), s = std::sin(step), of_y = at[y], of_z = at[z];
    at[y] = c * of_y + s * of_z;
    at[z] = c * of_z - s * of_y;
    return;
  }
  const double c = std::cos(step / 2), s = std::sin(step / 2);
  const double w = at[0], of_x = at[1 + x], of_y = at[1 + y], of_z = at[1 + z];
  at[0] = c * w - s * of_x;
  at[1 + x] = c * of_x + s * w;
  at[1 + y] = c * of_y + s * of_z;
  at[1 + z] = c * of_z - s * of_y;
}

// Calls a function.
using Call = std::function<std::vector<double>(const std::vector<double>& inputs)>;

inline std::vector<double> slice(const std::vector<double>& all, int first, int count) {
  return {all.begin() + first, all.begin() + first + count};
}

// The block as a matrix whose rows are those results: its place among the numbers that `numbers_of_matrix` returns.
inline reflection::Derivative as_matrix(reflection::Derivative d) {
  if (d.form == reflection::Form::matrix) return d;
  d.value = 0;
  if (d.form == reflection::Form::gradient) d.rows = 1;
  d.place = d.rows;
  d.form = reflection::Form::matrix;
  return d;
}

// Results of the function for these inputs, and derivatives by an input as a matrix. A gradient is the only row: that
// of the weighted sum of the results. Columns of a tangent are those for unit rates.
inline std::vector<double> numbers_of_matrix(
    const reflection::Derivative& d,
    const Call& call,
    std::vector<double> inputs) {
  if (d.form == reflection::Form::matrix) return call(inputs);
  const std::vector<double> results = call(inputs);
  std::vector<double> numbers = slice(results, d.value, d.rows);
  if (d.form == reflection::Form::gradient) {
    double sum = 0;
    for (int r = 0; r < d.rows; ++r)
      sum += inputs[static_cast<std::size_t>(d.vector + r)] * numbers[static_cast<std::size_t>(r)];
    const std::vector<double> gradient = slice(results, d.place, d.columns);
    numbers = {sum};
    numbers.insert(numbers.end(), gradient.begin(), gradient.end());
    return numbers;
  }
  for (int column = 0; column < d.columns; ++column) {
    for (int k = 0; k < d.columns; ++k) inputs[static_cast<std::size_t>(d.vector + k)] = k == column ? 1 : 0;
    const std::vector<double> tangent = slice(call(inputs), d.place, d.rows);
    numbers.insert(numbers.end(), tangent.begin(), tangent.end());
  }
  return numbers;
}

// Rates of all inputs but one are zero for a tangent by that one.
inline void clear_rates(
    const reflection::Table<reflection::Derivative>& derivatives,
    int function,
    std::vector<double>& inputs) {
  for (const reflection::Derivative& d : derivatives)
    if (d.function == function && d.form == reflection::Form::tangent)
      std::fill_n(inputs.begin() + d.vector, d.columns, 0.0);
}

// `inputs_of` returns the inputs of a function in one state. `cache_of` computes their first part from parameter
// values; `parameters` are the values of that state.
inline void check_partial_derivatives(
    const reflection::Table<reflection::Function>& functions,
    const reflection::Table<reflection::Derivative>& derivatives,
    const std::function<std::vector<double>(const reflection::Function&)>& inputs_of,
    const MoveInputs& move,
    const std::vector<double>& parameters,
    const std::function<std::vector<double>(const std::vector<double>&)>& cache_of,
    int samples,
    Checks& checks) {
  for (const reflection::Derivative& d : derivatives) {
    const reflection::Function& f = functions[d.function];
    bool is_checked = d.rows * d.columns == 0;
    for (int i = 0; i < samples; ++i) {
      std::vector<double> inputs = inputs_of(f);
      clear_rates(derivatives, d.function, inputs);
      const Call call = [&](const std::vector<double>& arguments) {
        std::vector<double> results(static_cast<std::size_t>(f.outputs));
        f.call(arguments.data(), results.data());
        return results;
      };
      const Real error = error_of(as_matrix(d), [&](int element, double step) {
        std::vector<double> moved = inputs;
        if (d.by_parameters) {
          std::vector<double> values = parameters;
          values[static_cast<std::size_t>(element)] += step;
          const std::vector<double> cache = cache_of(values);
          std::copy(cache.begin(), cache.end(), moved.begin());
        } else if (d.variation != reflection::Variation::of_input) {
          move_base(d, element, step, moved);
        } else {
          move(f, d, element, step, moved);
        }
        return numbers_of_matrix(d, call, std::move(moved));
      });
      if (std::isnan(error)) continue;
      is_checked = true;
      checks.record(std::string("derivatives: ") + d.name, kPartial, error, i);
    }
    checks.record("every derivative has values to compare", kPartial, is_checked ? 0 : 1, 0);
  }
}

}  // namespace robcogen::reference
