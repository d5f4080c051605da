#include "command/functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "driver/declare.h"
#include "driver/derivatives.h"
#include "driver/driver.h"
#include "driver/find_function.h"
#include "driver/formulations.h"
#include "pass/passes.h"

namespace robcogen::command {
namespace {

// The overloads of this name, which differ in their loads. Only the last one, which takes all arguments, is traced.
EvaluableFunction evaluable(
    const std::string& name,
    const std::vector<driver::Function>& overloads,
    const model::KinematicTree& tree,
    const driver::Steps& steps) {
  algorithm::FormulationChoices choices(tree, steps.formulation());
  symbolic::Program program = driver::traced(overloads.back(), choices).program;
  std::vector<symbolic::Program> outlines;
  for (const driver::Function& f : overloads) outlines.push_back(algorithm::outline(*f.declared));
  outlines.back() = program;
  return {signature_of(name, outlines, tree), pass::run(std::move(program), steps.passes())};
}

// The update of this name, among those that compute the cache of a robot with parameters.
std::optional<EvaluableFunction> find_update(
    const driver::Model& model,
    const std::string& name,
    const driver::Steps& steps) {
  if (model.parameters().empty()) return std::nullopt;
  driver::Functions functions = driver::programs(model, algorithm::groups(), steps, {.caches_parameters = true});
  for (symbolic::Function& f : functions.updates)
    if (dotted(f.scope, f.name) == name)
      return EvaluableFunction{signature_of(name, {f.program}, model.robot()->tree), std::move(f.program)};
  return std::nullopt;
}

EvaluableFunction find_function_of_robot(
    const driver::Model& model,
    const std::string& name,
    const driver::Steps& steps) {
  const driver::Robot& robot = *model.robot();
  const bool has_all = std::any_of(
      robot.derivatives.begin(), robot.derivatives.end(), [](const auto& derivative) { return derivative.is_all(); });
  std::vector<driver::Function> overloads =
      driver::declare(model, has_all ? algorithm::groups() : std::vector<std::string>{}).list;
  std::erase_if(overloads, [&](const driver::Function& f) { return dotted(f.scope, f.name) != name; });
  if (overloads.empty())
    for (algorithm::Declared& declared : driver::find_functions(robot, name))
      overloads.push_back(driver::function_of(std::move(declared)));
  if (!overloads.empty()) return evaluable(name, overloads, robot.tree, steps);
  if (std::optional<EvaluableFunction> update = find_update(model, name, steps)) return std::move(*update);
  driver::refuse_function(fmt::format("robot '{}'", robot.tree.name), model.file, name, driver::function_names(robot));
}

EvaluableFunction find_function_of_transforms(
    const driver::Model& model,
    const std::string& name,
    const driver::Steps& steps) {
  const model::CoordinateTransforms& document = model.transforms()->document;
  std::vector<std::string> names;
  for (driver::Function& f : driver::programs(model, {}, steps).list) {
    names.push_back(dotted(f.scope, f.name));
    if (names.back() == name) return {signature_of(name, f.program, document), std::move(f.program)};
  }
  driver::refuse_function(fmt::format("model '{}'", document.name), model.file, name, names);
}

}  // namespace

EvaluableFunction find_function(const driver::Model& model, const std::string& name, const driver::Steps& steps) {
  if (!model.robot()) return find_function_of_transforms(model, name, steps);
  driver::require_traceable(model);
  return find_function_of_robot(model, name, steps);
}

}  // namespace robcogen::command
