#include "driver/driver.h"

#include <utility>

#include "driver/optimise.h"

namespace robcogen::driver {

Functions programs(
    const Model& model,
    const std::vector<std::string>& groups,
    const Steps& steps,
    const backend::Features& features) {
  // The formulation is chosen during tracing, because it depends on the robot and the algorithm.
  const bool in_lanes = features.has_lanes && steps.has_lanes();
  Functions functions = in_lanes ? trace_for_lanes(model, groups, steps) : trace(model, groups, steps);
  return optimise(model, std::move(functions), steps, features);
}

backend::Library library(const Model& model, const LibraryOptions& options, const backend::Features& features) {
  const std::vector<std::string> groups = model.robot() ? options.groups : std::vector<std::string>{kTransformsGroup};
  Functions functions = programs(model, groups, options.steps, features);
  backend::Library result = assemble(model, options.names, groups, std::move(functions), options.primitives);
  result.has_batches = options.has_batches;
  result.levels = options.levels;
  result.has_single_precision = options.has_single_precision;
  return result;
}

}  // namespace robcogen::driver
