// Functions that are fused of random others, on random robots, compared with their parts in the textbook formulation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithm/catalogue/find.h"
#include "algorithm/catalogue/fused.h"
#include "coupled_robot.h"
#include "dice.h"
#include "looped_robot.h"
#include "pass/passes.h"
#include "random_drives.h"
#include "random_robot.h"
#include "spherical_robot.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric::fused_test {
namespace {

using model::KinematicTree;

constexpr double kSame = 1e-8;  // of results in double, in other link frames
constexpr int kRobots = 40;

// Of every four robots one has couplings, one has spherical joints, and one has loops.
std::optional<KinematicTree> random_tree(std::uint64_t seed) {
  if (seed % 4 == 3) return looped_tree(seed);
  KinematicTree tree = random_robot(seed, {.min_joints = 2, .max_joints = 10});
  if (seed % 3 == 0) tree = with_random_drives(std::move(tree), seed);
  if (seed % 4 == 2) return with_spherical_joints(tree, seed);
  return seed % 4 == 0 ? tree : coupled(tree, seed, seed % 8 == 1).robot;
}

// Names of functions of the state: bias forces, half of the time, and a few others.
std::vector<model::FusedFunction::Part> random_parts(
    Dice& dice,
    const KinematicTree& tree,
    const model::DesiredTransforms& desired) {
  const std::vector<std::string> groups = {
      "inverse_dynamics",
      "bias_forces",
      "forward_dynamics",
      "joint_space_inertia",
      "coriolis_matrix",
      "centroidal",
      "centroidal_bias",
      "energy",
      "transforms",
      "jacobians",
      "world",
      "jacobian_derivatives",
      "jacobians_with_base",
      "world_centroidal",
      "all_frames"};
  std::vector<std::string> names;
  for (const std::string& group : groups)
    for (const algorithm::Declared& f : algorithm::declared(tree, desired, group)) {
      const std::string name = algorithm::dotted(f.is->scope, f.name);
      const bool is_of_state = std::none_of(f.is->signature.inputs.begin(), f.is->signature.inputs.end(), [](auto& a) {
        return a.role == symbolic::Role::value || a.role == symbolic::Role::contact_compliance;
      });
      if (is_of_state && (names.empty() || names.back() != name)) names.push_back(name);
    }
  std::vector<model::FusedFunction::Part> parts;
  const auto add = [&](const std::string& name) {
    const bool is_new = std::none_of(parts.begin(), parts.end(), [&](const auto& p) { return p.function == name; });
    if (is_new && std::find(names.begin(), names.end(), name) != names.end()) parts.push_back({name});
  };
  if (dice.chance(0.5)) add("bias_forces");
  if (dice.chance(0.5)) add("joint_space_inertia");
  for (int k = 0; k < 5; ++k) add(names[static_cast<std::size_t>(dice.below(static_cast<int>(names.size())))]);
  return parts;
}

symbolic::Arrays<double> random_inputs(Dice& dice, const KinematicTree& tree, const symbolic::Program& program) {
  symbolic::Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs) {
    std::vector<double>& values = inputs[array.name];
    if (array.role == symbolic::Role::parameters) {
      values = algorithm::parameter_values(tree);
      continue;
    }
    const bool is_near = !tree.loops.empty() && array.role == symbolic::Role::joint_position;
    for (std::size_t k = 0; k < array.elements.size(); ++k)
      values.push_back(dice.between(-1, 1) * (is_near ? 0.05 : 1));
    for (const int first : array.quaternions) {
      double square = 0;
      for (int k = 0; k < 4; ++k) square += std::pow(values[static_cast<std::size_t>(first + k)], 2);
      for (int k = 0; k < 4; ++k) values[static_cast<std::size_t>(first + k)] /= std::sqrt(square);
    }
  }
  return inputs;
}

int compare(
    const algorithm::Declared& function,
    algorithm::FormulationChoices& choices,
    algorithm::FormulationChoices& plain,
    Dice& dice) {
  const symbolic::Program whole = pass::run(algorithm::trace(function, choices).program);
  const symbolic::Arrays<double> inputs = random_inputs(dice, function.subject.tree, whole);
  const symbolic::Arrays<double> found = symbolic::interpret<double>(whole, inputs);
  std::size_t place = 0;
  for (const algorithm::Declared& part : function.parts) {
    const symbolic::Program own = algorithm::trace(part, plain).program;
    symbolic::Arrays<double> of_part;
    for (const symbolic::InputArray& array : own.inputs) of_part[array.name] = inputs.at(array.name);
    const symbolic::Arrays<double> expected = symbolic::interpret<double>(own, of_part);
    for (const symbolic::OutputArray& array : own.outputs) {
      const std::vector<double>&values = found.at(whole.outputs.at(place).name), &wanted = expected.at(array.name);
      EXPECT_EQ(values.size(), wanted.size());
      double largest = 1, error = 0;
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        if (!std::isfinite(wanted[k])) continue;
        largest = std::max(largest, std::abs(wanted[k]));
        error = std::max(error, std::abs(values[k] - wanted[k]));
      }
      EXPECT_LT(error / largest, kSame) << function.kernel << ": " << whole.outputs[place].name;
      ++place;
    }
  }
  EXPECT_EQ(place, whole.outputs.size());
  return static_cast<int>(place);
}

TEST(FusedRobots, HaveTheResultsOfTheirParts) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    SCOPED_TRACE(seed);
    const std::optional<KinematicTree> tree = random_tree(seed);
    if (!tree) continue;
    Dice dice(seed);
    model::DesiredTransforms desired = random_desired(seed, *tree);
    desired.functions.push_back({"whole", random_parts(dice, *tree, desired)});
    if (desired.functions.front().parts.size() < 2) continue;
    algorithm::FormulationChoices plain(*tree, algorithm::plain_formulation());
    algorithm::FormulationChoices choices(*tree, {});
    const std::vector<std::vector<algorithm::Declared>> fused = algorithm::fused_functions(*tree, desired);
    for (const algorithm::Declared& function : fused.front()) compared += compare(function, choices, plain, dice);
  }
  EXPECT_GT(compared, 4 * kRobots);
}

}  // namespace
}  // namespace robcogen::numeric::fused_test
