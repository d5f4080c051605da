#include "command/functions.h"

#include <fmt/format.h>

#include <utility>

#include "driver/derivatives.h"
#include "driver/driver.h"
#include "driver/find_function.h"
#include "pass/passes.h"

namespace robcogen::command {
namespace {

using algorithm::RobotFunction;

// The overloads of this name, which differ in their loads.
EvaluableFunction evaluable(
    const std::string& name,
    std::vector<RobotFunction> overloads,
    const model::KinematicTree& tree,
    const std::vector<std::string>& passes) {
  std::vector<const symbolic::Program*> programs;
  for (const RobotFunction& f : overloads) programs.push_back(&f.program);
  Signature signature = signature_of(name, programs, tree);
  return {std::move(signature), pass::run(std::move(overloads.back().program), passes)};
}

// The update of this name, among those that compute the cache of a robot with parameters.
std::optional<EvaluableFunction> find_update(
    const driver::Model& model,
    const std::string& name,
    const driver::Steps& steps) {
  if (model.parameters().empty()) return std::nullopt;
  driver::Functions functions = driver::programs(model, algorithm::groups(), steps, {.caches_parameters = true});
  for (backend::Function& f : functions.updates)
    if (dotted(f.scope, f.name) == name)
      return EvaluableFunction{signature_of(name, {&f.program}, model.robot()->tree), std::move(f.program)};
  return std::nullopt;
}

EvaluableFunction find_function_of_robot(
    const driver::Model& model,
    const std::string& name,
    const driver::Steps& steps) {
  const driver::Robot& robot = *model.robot();
  const std::vector<std::string> passes = steps.passes();
  algorithm::FormulationChoices formulations(robot.tree, steps.formulation());
  std::vector<RobotFunction> derivatives;
  for (RobotFunction& f : driver::derivative_functions(robot, model.file, formulations))
    if (dotted(f.scope, f.name) == name) derivatives.push_back(std::move(f));
  if (!derivatives.empty()) return evaluable(name, std::move(derivatives), robot.tree, passes);
  driver::FoundFunctions found = driver::find_functions(robot, name, formulations);
  if (!found.overloads.empty()) return evaluable(name, std::move(found.overloads), robot.tree, passes);
  if (std::optional<EvaluableFunction> update = find_update(model, name, steps)) return std::move(*update);
  driver::refuse_function(fmt::format("robot '{}'", robot.tree.name), model.file, name, found.names);
}

EvaluableFunction find_function_of_transforms(
    const driver::Model& model,
    const std::string& name,
    const driver::Steps& steps) {
  const model::CoordinateTransforms& document = model.transforms()->document;
  std::vector<std::string> names;
  for (driver::Function& f : driver::programs(model, {}, steps).list) {
    names.push_back(dotted(f.traced.scope, f.traced.name));
    if (names.back() == name) return {signature_of(name, f.traced.program, document), std::move(f.traced.program)};
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
