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

// In this formulation of the limbs, where that is another program.
std::optional<symbolic::Program> congruent_program(RobotFunction&& f) {
  if (!algorithm::folds_like_others(f.program)) return std::nullopt;
  return std::move(f.program);
}

Functions trace_robot(
    const Robot& robot,
    const std::filesystem::path& file,
    const std::vector<std::string>& groups,
    const algorithm::Formulation& formulation,
    bool for_lanes) {
  algorithm::FormulationChoices choices(robot.tree, formulation);
  std::vector<std::vector<Function>> of_groups(groups.size());
  for_each_index(groups.size(), [&](std::size_t g) {
    for (RobotFunction& f : algorithm::functions(robot.tree, robot.desired, groups[g], choices))
      of_groups[g].push_back({std::move(f)});
  });
  std::vector<Function>& derivatives = of_groups.emplace_back();
  for (RobotFunction& f : derivative_functions(robot, file, choices)) derivatives.push_back({std::move(f)});
  if (for_lanes && robot.tree.parameters.empty() && !algorithm::limbs_in_lanes(robot.tree).empty()) {
    auto for_congruent_limbs = algorithm::FormulationChoices::for_congruent_limbs(choices);
    for_each_index(groups.size(), [&](std::size_t g) {
      auto programs = algorithm::congruent_programs(robot.tree, robot.desired, groups[g], for_congruent_limbs);
      for (std::size_t i = 0; i < programs.size(); ++i) of_groups[g][i].congruent = std::move(programs[i]);
    });
    std::vector<RobotFunction> programs = derivative_functions(robot, file, for_congruent_limbs);
    for (std::size_t i = 0; i < programs.size(); ++i)
      derivatives[i].congruent = congruent_program(std::move(programs[i]));
  }
  Functions result;
  for (std::vector<Function>& functions : of_groups)
    std::move(functions.begin(), functions.end(), std::back_inserter(result.list));
  return result;
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

}  // namespace

void require_traceable(const Model& model) {
  const model::KinematicTree& tree = model.robot()->tree;
  const int joints = static_cast<int>(tree.joints.size());
  if (joints <= kMaxJoints) return;
  throw Failure{
      wrong_input, fmt::format(
                       "{}: error: robot '{}' has {} joints; programs are made for at most {} [too-many-joints]",
                       model.file.string(), tree.name, joints, kMaxJoints)};
}

Functions trace(const Model& model, const std::vector<std::string>& groups, const Steps& steps, bool for_lanes) {
  if (!model.robot()) return trace_transforms(*model.transforms(), model.file);
  require_traceable(model);
  return trace_robot(*model.robot(), model.file, groups, steps.formulation(), for_lanes);
}

}  // namespace robcogen::driver
