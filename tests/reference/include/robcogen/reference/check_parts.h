// Checks of fused functions against the functions whose results they have.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "robcogen/reference/checks.h"
#include "robcogen/reflection.h"

namespace robcogen::reference {

inline constexpr Tolerance kPart{"kPart", 1e-8, "the same results in double, in other link frames"};

// The largest difference between the results of a part and the same ones of the fused function, relative to the largest
// of them. Where the part has no finite result, neither may the function.
inline Real error_of(
    const reflection::Table<reflection::Function>& functions,
    const reflection::Part& p,
    const std::vector<double>& inputs) {
  const reflection::Function &whole = functions[p.function], &part = functions[p.part];
  std::vector<double> own(static_cast<std::size_t>(part.inputs)), expected(static_cast<std::size_t>(part.outputs)),
      found(static_cast<std::size_t>(whole.outputs));
  for (int k = 0; k < p.input_count; ++k) {
    const reflection::PartInput& run = p.inputs[k];
    std::copy_n(inputs.begin() + run.of_function, run.size, own.begin() + run.of_part);
  }
  part.call(own.data(), expected.data());
  whole.call(inputs.data(), found.data());
  Real largest = 1, error = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double of_whole = found[static_cast<std::size_t>(p.place) + i];
    if (!std::isfinite(expected[i])) {
      if (std::isfinite(of_whole)) return 1;
      continue;
    }
    largest = std::max(largest, std::abs(static_cast<Real>(expected[i])));
    error = std::max(error, std::abs(static_cast<Real>(expected[i]) - static_cast<Real>(of_whole)));
  }
  return error / largest;
}

// `inputs_of` returns the inputs of a function in one state.
inline void check_parts(
    const reflection::Table<reflection::Function>& functions,
    const reflection::Table<reflection::Part>& parts,
    const std::function<std::vector<double>(const reflection::Function&)>& inputs_of,
    int samples,
    Checks& checks) {
  for (const reflection::Part& p : parts)
    for (int i = 0; i < samples; ++i)
      checks.record(
          std::string("fused functions: ") + p.name, kPart, error_of(functions, p, inputs_of(functions[p.function])),
          i);
}

}  // namespace robcogen::reference
