// The cost of parameters: operations of a parametric robot compared with those of its constant twin.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "algorithm/catalogue/catalogue.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "pass/passes.h"
#include "pass/split_parameters.h"
#include "symbolic/cost.h"

namespace robcogen::numeric::parameters_cost_test {
namespace {

using model::KinematicTree;
using model::ParameterKind;
using model::Quantity;

// Constants fold into fewer sums than parameters, and allow link frames in which products of inertia vanish. The main
// functions are inverse and forward dynamics with their first derivatives, and the inertia matrix. Each function may
// have two instructions more, which matters for functions of about ten. Of the other functions the Coriolis matrix of
// the quadruped is the worst.
constexpr double kMaxRatio = 1.1, kMaxRatioOfOthers = 1.6;
constexpr int kAlways = 2;

KinematicTree robot_of(const std::string& name) {
  const auto path = std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / name / (name + ".kindsl");
  std::ifstream file(path, std::ios::binary);
  const auto source = std::make_shared<Source>(path.string(), std::string(std::istreambuf_iterator<char>(file), {}));
  Diagnostics diagnostics;
  const auto read = import::robot_document(source, {}, diagnostics);
  const auto tree = read ? import::kinematic_tree(read->document, diagnostics) : std::nullopt;
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  return tree.value_or(KinematicTree());
}

// With every length and every mass as a parameter, a robot costs hardly more than its constant twin.
TEST(Parameters, CostLittleOnceTheyAreSplitOff) {
  for (const std::string name : {"hyl", "puma560", "quadruped_fixed", "quadruped"}) {
    const KinematicTree constant = robot_of(name);
    KinematicTree robot = constant;
    const auto make_parameter = [&](Quantity& q, ParameterKind kind) {
      if (q.is_zero()) return;
      q = Quantity::parameter(static_cast<int>(robot.parameters.size()));
      robot.parameters.push_back({"p" + std::to_string(robot.parameters.size()), kind, {}, {}});
    };
    for (model::Joint& joint : robot.joints)
      for (Quantity& q : joint.placement.translation) make_parameter(q, ParameterKind::length);
    for (model::Link& link : robot.links)
      if (link.inertia) make_parameter(link.inertia->mass, ParameterKind::inertial);
    std::vector<pass::Interfaces> interfaces;
    for (const model::Parameter& p : robot.parameters)
      interfaces.push_back({model::is_kinematics(p), model::is_dynamics(p)});

    algorithm::FormulationChoices parametric_frames(robot, {.effort = 1}), constant_frames(constant, {.effort = 1});
    std::vector<symbolic::Program> programs, constants;
    for (const std::string& group : algorithm::groups()) {
      if (group == "transforms" || group == "jacobians") continue;
      for (const symbolic::Function& f : algorithm::functions(robot, {}, group, parametric_frames))
        if (f.name != "total_mass") programs.push_back(f.program);  // a constant for the twin
      for (const symbolic::Function& f : algorithm::functions(constant, {}, group, constant_frames))
        constants.push_back(f.program);
    }
    const pass::SplitPrograms split = pass::split_parameters(programs, interfaces);
    for (std::size_t k = 0; k < programs.size(); ++k) {
      const int parametric_cost = symbolic::cost(pass::run(split.programs[k])).instructions;
      const int constant_cost = symbolic::cost(pass::run(constants[k])).instructions;
      const std::string& function = programs[k].name;
      const auto names = [&](const char* word) { return function.find(word) != std::string::npos; };
      const bool is_main = (names("dynamics") && !names("second_derivatives") && !names("path_dynamics")) ||
                           function == "joint_space_inertia";
      EXPECT_LE(parametric_cost, (is_main ? kMaxRatio : kMaxRatioOfOthers) * constant_cost + kAlways)
          << name << " " << function;
    }
  }
}

}  // namespace
}  // namespace robcogen::numeric::parameters_cost_test
