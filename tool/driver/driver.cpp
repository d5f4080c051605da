#include "driver/driver.h"

#include <string>
#include <utility>
#include <vector>

#include "driver/collision_check.h"
#include "driver/optimise.h"
#include "pass/kernel_form.h"
#include "support/parallel.h"

namespace robcogen::driver {

Functions programs(
    const Model& model,
    const std::vector<std::string>& groups,
    const Steps& steps,
    const backend::Features& features) {
  return optimise(model, declare(model, groups), steps, features);
}

namespace {

void choose_kernels(backend::Library& library) {
  std::vector<symbolic::Function*> all;
  for (std::vector<symbolic::Function>* list :
       {&library.functions, &library.right_sides, &library.updates, &library.numbers})
    for (symbolic::Function& f : *list) all.push_back(&f);
  if (library.trigonometry) all.push_back(&library.trigonometry->addition);
  for_each_index(all.size(), [&](std::size_t i) {
    const std::string& group = all[i]->group;
    const bool is_default = group == "jacobians" || group == kTransformsGroup;
    all[i]->form = pass::kernel_form(*all[i], {backend::is_kinematics(group), is_default});
  });
}

}  // namespace

backend::Library library(const Model& model, const LibraryOptions& options, const backend::Features& features) {
  const std::vector<std::string> groups = model.robot() ? options.groups : std::vector<std::string>{kTransformsGroup};
  Functions functions = programs(model, groups, options.steps, features);
  backend::Library result = library_of(model, options.names, groups, std::move(functions), options.primitives);
  if (features.has_lanes) choose_kernels(result);
  if (features.checks_collisions && model.robot())
    result.collision_check = collision_check(model.robot()->tree, groups, options.steps);
  result.has_batches = options.has_batches;
  result.levels = options.levels;
  result.has_single_precision = options.has_single_precision;
  return result;
}

}  // namespace robcogen::driver
