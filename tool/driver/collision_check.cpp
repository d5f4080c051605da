#include "driver/collision_check.h"

#include <algorithm>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/kinematics/collision_check.h"
#include "pass/passes.h"

namespace robcogen::driver {
namespace {

using symbolic::Operand;

// The program without its input of parameters. None if it reads them.
std::optional<symbolic::Program> without_parameters(symbolic::Program program) {
  if (program.inputs.front().role != symbolic::Role::parameters) return program;
  const int count = static_cast<int>(program.inputs.front().elements.size());
  bool reads_parameters = false;
  const auto move = [&](Operand& o) {
    if (o.kind != Operand::Kind::input) return;
    o.index -= count;
    reads_parameters = reads_parameters || o.index < 0;
  };
  for (symbolic::Statement& s : program.statements) for_each_operand(s, move);
  for (symbolic::OutputArray& output : program.outputs) std::for_each(output.values.begin(), output.values.end(), move);
  program.inputs.erase(program.inputs.begin());
  return reads_parameters ? std::nullopt : std::optional(std::move(program));
}

}  // namespace

std::optional<backend::CollisionCheck> collision_check(
    const model::KinematicTree& tree,
    const std::vector<std::string>& groups,
    const Steps& steps) {
  if (std::find(groups.begin(), groups.end(), algorithm::kCollisionGroup) == groups.end()) return std::nullopt;
  backend::CollisionCheck result{model::collision_tree(tree), {}};
  if (result.shapes.parts.empty()) return std::nullopt;
  const std::optional<symbolic::Program> program =
      without_parameters(pass::run(algorithm::collision_check(tree, result.shapes, "collision_check"), steps.passes()));
  if (!program) return std::nullopt;
  result.stages = algorithm::in_stages(*program, result.shapes);
  return result;
}

}  // namespace robcogen::driver
