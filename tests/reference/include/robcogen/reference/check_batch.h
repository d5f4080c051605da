// Checks of functions over many states against the same functions of one state.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "robcogen/reference/check_trigonometry.h"
#include "robcogen/reference/levels.h"

namespace robcogen::reference {

// Two of the widest blocks, and states that do not fill a block.
inline constexpr int kManyStatesCount = 19;

// Checks one function in one layout, at every processor level that this machine can run.
inline void check_batch(
    const Robot& robot,
    const reflection::Function& single,
    const reflection::BatchFunction& many,
    const std::vector<double>& cache,
    bool by_state,
    std::mt19937_64& engine,
    Checks& checks) {
  constexpr std::ptrdiff_t n = kManyStatesCount;
  const auto read = static_cast<std::size_t>(many.inputs), written = static_cast<std::size_t>(many.outputs);
  std::vector<double> inputs(read * n), expected(written * n);
  const auto strided = [&](double* data, std::size_t elements) {
    const auto size = static_cast<std::ptrdiff_t>(elements);
    return by_state ? batch::Strided<double>{data, 1, size} : batch::Strided<double>{data, n, 1};
  };
  const auto at = [](const batch::Strided<double>& array, std::ptrdiff_t state, std::size_t k) -> double& {
    return array.data[static_cast<std::ptrdiff_t>(k) * array.element + state * array.state];
  };
  const batch::Strided<double> in = strided(inputs.data(), read), all = strided(expected.data(), written);
  // Functions that solve with a factor read the factor, and no parameters.
  const std::size_t before = static_cast<std::size_t>(single.inputs) - read;
  const std::vector<double> parameters(cache.begin(), before > 0 ? cache.end() : cache.begin());
  std::vector<double> results(written);
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::vector<double> one = random_inputs(engine, robot, single, parameters);
    for (std::size_t k = 0; k < read; ++k) at(in, i, k) = one[before + k];
    single.call(one.data(), results.data());
    for (std::size_t k = 0; k < written; ++k) at(all, i, k) = results[k];
  }
  for (const batch::Level level : available_levels()) {
    std::vector<double> found(expected.size(), std::numeric_limits<double>::quiet_NaN());
    many.call(cache.data(), n, {in.data, in.element, in.state}, strided(found.data(), written), level);
    Difference difference;
    difference.add(expected, found);
    const std::string layout = by_state ? "by state" : "by element";
    record_other_rounding(checks, "many states, " + layout, single, difference.relative());
  }
}

// Checks every function of the table. A function without a counterpart for one state has an infinite error.
inline void check_batches(
    const Robot& robot,
    const reflection::BatchFunctions& functions,
    const std::vector<double>& cache,
    std::mt19937_64& engine,
    Checks& checks) {
  for (const reflection::BatchFunction& many : functions) {
    const reflection::Function* single = std::find_if(
        robot.functions.begin(), robot.functions.end(),
        [&](const reflection::Function& f) { return std::strcmp(f.name, many.name) == 0; });
    if (single == robot.functions.end()) {
      checks.record(std::string(many.name) + " of one state", kOtherRounding, std::numeric_limits<Real>::infinity(), 0);
      continue;
    }
    for (const bool by_state : {false, true}) check_batch(robot, *single, many, cache, by_state, engine, checks);
  }
}

}  // namespace robcogen::reference
