#include "command/functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "command/status.h"
#include "driver/driver.h"
#include "pass/passes.h"

namespace robcogen::command {
namespace {

using algorithm::RobotFunction;

// The names of functions of two frames: `jacobians.` A `_J_` B.
struct NamePattern {
  std::string group;
  std::string prefix;
  std::string separator;

  std::string name(const model::FramePair& pair) const { return prefix + pair.left.name + separator + pair.right.name; }
};

// From the functions between two frames of the robot.
std::vector<NamePattern> patterns(const model::KinematicTree& tree, algorithm::FormulationChoices& formulations) {
  const std::vector<model::Frame> frames = tree.frames();
  const model::FramePair pair = {frames.front(), frames.back()};
  const model::DesiredTransforms desired = {{pair}, {pair}};
  std::vector<NamePattern> found;
  for (const std::string& group : algorithm::groups_between_frames())
    for (const RobotFunction& f : algorithm::functions(tree, desired, group, formulations)) {
      if (f.frames.left.name.empty()) continue;  // of the whole robot
      const std::size_t begin = pair.left.name.size();
      found.push_back(
          {group, dotted(f.scope, ""), f.name.substr(begin, f.name.size() - begin - pair.right.name.size())});
    }
  return found;
}

// A name that matches a pattern with two frames of the robot.
std::optional<model::FramePair> frames_in(
    const model::KinematicTree& tree,
    const NamePattern& pattern,
    const std::string& name) {
  if (!name.starts_with(pattern.prefix)) return std::nullopt;
  const std::string rest = name.substr(pattern.prefix.size());
  for (std::size_t at = rest.find(pattern.separator); at != std::string::npos;
       at = rest.find(pattern.separator, at + 1)) {
    const auto left = tree.find_frame(rest.substr(0, at));
    const auto right = tree.find_frame(rest.substr(at + pattern.separator.size()));
    if (left && right) return model::FramePair{*left, *right};
  }
  return std::nullopt;
}

// All groups, first the one with the name of the function, last those whose functions are between frames: few of them
// are of the whole robot.
std::vector<std::string> groups_of_robot(const std::string& name) {
  const std::vector<std::string>& last = algorithm::groups_between_frames();
  std::vector<std::string> groups = algorithm::groups();
  std::stable_partition(groups.begin(), groups.end(), [&](const std::string& group) {
    return std::find(last.begin(), last.end(), group) == last.end();
  });
  std::stable_partition(groups.begin(), groups.end(), [&](const std::string& group) { return group == name; });
  return groups;
}

[[noreturn]] void refuse_function(
    const std::string& owner,
    const std::filesystem::path& model,
    const std::string& name,
    const std::vector<std::string>& names) {
  const std::string guess = did_you_mean(name, names);
  throw Failure{
      wrong_usage, with_hint(
                       fmt::format("robcogen: error: {} has no function '{}' [unknown-function]", owner, name),
                       guess.empty() ? fmt::format("'robcogen ops {}' lists them", model.string()) : guess)};
}

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

// The update of that name among those that compute the cache of a robot with parameters.
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
  std::vector<std::string> names;
  const auto chosen = [&](std::vector<RobotFunction> functions) {
    std::vector<RobotFunction> overloads;
    for (RobotFunction& f : functions) {
      names.push_back(dotted(f.scope, f.name));
      if (names.back() == name) overloads.push_back(std::move(f));
    }
    return overloads;
  };
  const auto search = [&](const std::string& group, const model::DesiredTransforms& desired) {
    return chosen(algorithm::functions(robot.tree, desired, group, formulations));
  };

  // Functions of the whole robot have no name with two frames: this test is the fastest.
  const std::vector<NamePattern> known = patterns(robot.tree, formulations);
  for (const NamePattern& pattern : known) {
    const std::optional<model::FramePair> pair = frames_in(robot.tree, pattern, name);
    if (!pair) continue;
    std::vector<RobotFunction> found = search(pattern.group, {{*pair}, {*pair}});
    if (!found.empty()) return evaluable(name, std::move(found), robot.tree, passes);
  }
  for (const std::string& group : groups_of_robot(name)) {
    std::vector<RobotFunction> found = search(group, {});
    if (!found.empty()) return evaluable(name, std::move(found), robot.tree, passes);
  }
  if (std::optional<EvaluableFunction> update = find_update(model, name, steps)) return std::move(*update);
  for (const NamePattern& pattern : known)
    for (const auto* pairs : {&robot.desired.transforms, &robot.desired.jacobians})
      for (const model::FramePair& pair : *pairs) names.push_back(pattern.name(pair));
  refuse_function(fmt::format("robot '{}'", robot.tree.name), model.file, name, names);
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
  refuse_function(fmt::format("model '{}'", document.name), model.file, name, names);
}

}  // namespace

EvaluableFunction find_function(const driver::Model& model, const std::string& name, const driver::Steps& steps) {
  if (!model.robot()) return find_function_of_transforms(model, name, steps);
  driver::require_traceable(model);
  return find_function_of_robot(model, name, steps);
}

}  // namespace robcogen::command
