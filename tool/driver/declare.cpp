#include "driver/declare.h"

#include <fmt/format.h>

#include <utility>

#include "algorithm/catalogue/transform_functions.h"
#include "driver/derivatives.h"
#include "driver/failure.h"

namespace robcogen::driver {
namespace {

Functions declare_robot(const Robot& robot, const std::filesystem::path& file, const std::vector<std::string>& groups) {
  Functions result;
  for (const std::string& group : groups)
    for (algorithm::Declared& declared : algorithm::declared(robot.tree, robot.desired, group))
      result.list.push_back(function_of(std::move(declared)));
  for (Function& f : derivative_functions(robot, result.list, file)) result.list.push_back(std::move(f));
  return result;
}

Functions trace_transforms(const Transforms& transforms, const std::filesystem::path& file) {
  Functions result;
  for (symbolic::Function& f : algorithm::transform_functions(transforms.document))
    result.list.push_back({std::move(f)});
  for (symbolic::Function& f : derivative_functions(transforms, result.list, file))
    result.list.push_back({std::move(f)});
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

Functions declare(const Model& model, const std::vector<std::string>& groups) {
  if (!model.robot()) return trace_transforms(*model.transforms(), model.file);
  require_traceable(model);
  return declare_robot(*model.robot(), model.file, groups);
}

}  // namespace robcogen::driver
