#include "driver/trace.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "algorithm/catalogue/transform_functions.h"
#include "algorithm/formulation/congruent_limbs.h"
#include "driver/derivatives.h"
#include "driver/failure.h"
#include "support/parallel.h"

namespace robcogen::driver {
namespace {

using algorithm::RobotFunction;

// The program in this formulation of the limbs, if it is a different program.
std::optional<symbolic::Program> congruent_program(RobotFunction&& f) {
  if (!algorithm::folds_like_others(f.program)) return std::nullopt;
  return std::move(f.program);
}

// The functions of each group. The derivatives that the model asks for are one more group.
using OfGroups = std::vector<std::vector<Function>>;

Functions in_one_list(OfGroups&& of_groups) {
  Functions result;
  for (std::vector<Function>& functions : of_groups)
    std::move(functions.begin(), functions.end(), std::back_inserter(result.list));
  return result;
}

OfGroups trace_robot(
    const Robot& robot,
    const std::filesystem::path& file,
    const std::vector<std::string>& groups,
    algorithm::FormulationChoices& choices) {
  OfGroups of_groups(groups.size());
  for_each_index(groups.size(), [&](std::size_t g) {
    for (RobotFunction& f : algorithm::functions(robot.tree, robot.desired, groups[g], choices))
      of_groups[g].push_back({std::move(f)});
  });
  std::vector<Function>& derivatives = of_groups.emplace_back();
  for (RobotFunction& f : derivative_functions(robot, file, choices)) derivatives.push_back({std::move(f)});
  return of_groups;
}

void add_congruent_programs(
    const Robot& robot,
    const std::filesystem::path& file,
    const std::vector<std::string>& groups,
    algorithm::FormulationChoices& for_congruent_limbs,
    OfGroups& of_groups) {
  for_each_index(groups.size(), [&](std::size_t g) {
    auto programs = algorithm::congruent_programs(robot.tree, robot.desired, groups[g], for_congruent_limbs);
    for (std::size_t i = 0; i < programs.size(); ++i) of_groups[g][i].congruent = std::move(programs[i]);
  });
  std::vector<Function>& derivatives = of_groups.back();
  std::vector<RobotFunction> programs = derivative_functions(robot, file, for_congruent_limbs);
  for (std::size_t i = 0; i < programs.size(); ++i)
    derivatives[i].congruent = congruent_program(std::move(programs[i]));
}

bool is_worth_lanes(const model::KinematicTree& tree) {
  return tree.parameters.empty() && !algorithm::limbs_in_lanes(tree).empty();
}

Functions trace_transforms(const Transforms& transforms, const std::filesystem::path& file) {
  Functions result;
  const auto add = [&](algorithm::TransformFunction& f, const char* group) {
    RobotFunction traced;
    traced.group = group;
    traced.derivatives = std::move(f.derivatives);
    traced.scope = std::move(f.scope);
    traced.name = std::move(f.name);
    traced.summary = std::move(f.summary);
    traced.program = std::move(f.program);
    result.list.push_back({std::move(traced), static_cast<int>(f.transform)});
  };
  for (algorithm::TransformFunction& f : algorithm::transform_functions(transforms.document)) add(f, kTransformsGroup);
  for (algorithm::TransformFunction& f : derivative_functions(transforms, file)) add(f, kDerivativesGroup);
  return result;
}

bool has_too_many_joints(const Model& model) {
  return model.robot() && static_cast<int>(model.robot()->tree.joints.size()) > kMaxJoints;
}

std::string too_many_joints(const Model& model) {
  const model::KinematicTree& tree = model.robot()->tree;
  return fmt::format("robot '{}' has {} joints; the limit is {}", tree.name, tree.joints.size(), kMaxJoints);
}

}  // namespace

void mention_joint_limit(const Model& model, Diagnostics& diagnostics) {
  if (!has_too_many_joints(model)) return;
  const model::Joint& first = model.robot()->tree.joints[static_cast<std::size_t>(kMaxJoints)];
  diagnostics.warning("too-many-joints", first.place, too_many_joints(model)).hint =
      "a larger robot can be checked, printed and converted only";
}

void require_traceable(const Model& model) {
  if (!has_too_many_joints(model)) return;
  throw Failure{
      wrong_input, fmt::format("{}: error: {} [too-many-joints]", model.file.string(), too_many_joints(model))};
}

Functions trace(const Model& model, const std::vector<std::string>& groups, const Steps& steps) {
  if (!model.robot()) return trace_transforms(*model.transforms(), model.file);
  require_traceable(model);
  algorithm::FormulationChoices choices(model.robot()->tree, steps.formulation());
  return in_one_list(trace_robot(*model.robot(), model.file, groups, choices));
}

Functions trace_for_lanes(const Model& model, const std::vector<std::string>& groups, const Steps& steps) {
  if (!model.robot()) return trace(model, groups, steps);
  require_traceable(model);
  algorithm::FormulationChoices choices(model.robot()->tree, steps.formulation());
  OfGroups of_groups = trace_robot(*model.robot(), model.file, groups, choices);
  if (is_worth_lanes(model.robot()->tree)) {
    auto for_congruent_limbs = algorithm::FormulationChoices::for_congruent_limbs(choices);
    add_congruent_programs(*model.robot(), model.file, groups, for_congruent_limbs, of_groups);
  }
  return in_one_list(std::move(of_groups));
}

}  // namespace robcogen::driver
