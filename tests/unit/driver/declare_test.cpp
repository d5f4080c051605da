// From models to the functions of their libraries.
#include "driver/declare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "documents.h"
#include "driver/formulations.h"
#include "driver/failure.h"
#include "driver/steps.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"

namespace robcogen::driver::declare_test {
namespace {

using namespace test;

TEST(Declare, ListsTheFunctionsOfEachGroupInTurn) {
  const Model model = rods();
  const Functions functions = declare(model, {"joint_space_inertia", "inverse_dynamics"});
  ASSERT_GE(functions.list.size(), 3U);  // one inertia matrix, and inverse dynamics with several loads
  EXPECT_EQ(functions.list.front().group, "joint_space_inertia");
  for (std::size_t i = 1; i < functions.list.size(); ++i) EXPECT_EQ(functions.list[i].group, "inverse_dynamics");
}

// Weights by hand: both masses about the shoulder, the second one about the elbow.
TEST(Declare, NamesWhatTheRobotDoes) {
  const double q1 = 0.4, q2 = -1.1;
  const Model model = rods();
  for (const std::vector<std::string>& names : {std::vector<std::string>(), all_steps()}) {
    const Functions functions = declare(model, {"inverse_dynamics"});
    Formulations formulations(*model.robot(), Steps{names}.formulation());
    const symbolic::Function f = traced(functions.list.at(0), formulations.of(Formulated::searched));
    const auto tau = symbolic::interpret<double>(f.program, {{"q", {q1, q2}}}).at("tau");
    const double second = kGravity * kM2 * kL2 * std::cos(q1 + q2);
    EXPECT_NEAR(tau[0], kGravity * (kM1 + kM2) * kL1 * std::cos(q1) + second, 1e-13);
    EXPECT_NEAR(tau[1], second, 1e-13);
  }
}

TEST(Declare, OfTransformsKnowsWhichOneEachFunctionIs) {
  const Folder folder;
  const Model model = loaded(folder.file("arm.motdsl", kMotions));
  const Functions functions = declare(model, {kTransformsGroup});
  const auto& transforms = model.transforms()->document.transforms;
  ASSERT_EQ(functions.list.size(), 3 * transforms.size());  // homogeneous, motion, force
  for (std::size_t k = 0; k < functions.list.size(); ++k) {
    const Function& f = functions.list[k];
    const model::CoordinateTransform& t = transforms.at(k % transforms.size());
    EXPECT_EQ(f.group, kTransformsGroup);
    EXPECT_EQ(f.name, t.left + "_X_" + t.right);
    EXPECT_EQ(f.left, t.left);
    EXPECT_EQ(f.right, t.right);
  }
}

std::string shape_of(const symbolic::Program& p) {
  std::string text = p.name + ":";
  for (const symbolic::InputArray& array : p.inputs)
    text += fmt::format(" {} {}({})", array.name, static_cast<int>(array.role), array.elements.size());
  text += " ->";
  for (const symbolic::OutputArray& array : p.outputs)
    text += fmt::format(" {} {}({}, {})", array.name, static_cast<int>(array.role), array.rows, array.columns);
  return text;
}

class Declared : public testing::TestWithParam<const char*> {};

// What a declaration says of a function without tracing it is true of its program: names, inputs, outputs.
TEST_P(Declared, FunctionsHaveTheirInputsAndOutputs) {
  const std::string folder = std::string(ROBCOGEN_ROBOTS_DIR) + "/" + GetParam() + "/";
  Diagnostics diagnostics;
  const std::optional<Model> model = load(folder + GetParam() + ".kindsl", {}, diagnostics);
  ASSERT_TRUE(model) << diagnostics.render();
  const Robot& robot = *model->robot();
  model::DesiredTransforms desired = robot.desired;
  const std::vector<model::Frame> frames = robot.tree.frames();
  desired.contacts = {{frames.back()}, {frames[1], true}};
  using Kind = model::InverseTask::Kind;
  desired.inverses = {{{frames.front(), frames.back()}, {Kind::point}}, {{frames.front(), frames[1]}, {Kind::pose}}};
  desired.transforms.resize(std::min<std::size_t>(desired.transforms.size(), 2));
  desired.jacobians.resize(std::min<std::size_t>(desired.jacobians.size(), 2));
  algorithm::FormulationChoices choices(robot.tree, algorithm::plain_formulation());
  for (const std::string& group : algorithm::groups())
    for (const algorithm::Declared& function : algorithm::declared(robot.tree, desired, group)) {
      const symbolic::Function f = algorithm::trace(function, choices);
      EXPECT_EQ(shape_of(algorithm::outline(function)), shape_of(f.program));
      EXPECT_EQ(f.kernel, function.kernel);
      EXPECT_EQ(f.name, function.name);
      EXPECT_FALSE(f.summary.empty());
      EXPECT_EQ(f.summary.front().find('{'), std::string::npos) << f.summary.front();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Robots,
    Declared,
    testing::Values("hyl_parametric", "ankle", "ball_leg", "five_bar", "gripper", "geared_leg", "quadruped", "wrist"),
    [](const auto& robot) { return std::string(robot.param); });

// Two rods next to each other on a base; the mass of one is slightly off its rod.
Model two_arms(const std::string& second_com) {
  std::string text = "Robot Arms { RobotBase body { children { L via L_joint R via R_joint } }\n";
  int id = 1;
  for (const auto& [name, com] : {std::pair<std::string, std::string>("L", "(0.5, 0.0, 0.0)"), {"R", second_com}})
    text += "link " + name + " { id = " + std::to_string(id++) + " inertia_params { mass = 1.0 CoM = " + com +
            " Ix = 0.3 Iy = 0.4 Iz = 0.5 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} }\n";
  for (const std::string name : {"L", "R"})
    text += "r_joint " + name + "_joint { ref_frame { translation = (0.0, " + (name == "L" ? "0.25" : "-0.25") +
            ", 0.0) rotation = (PI/2.0, 0.0, 0.0) } }\n";
  const Folder folder;
  return loaded(folder.file("arms.kindsl", text + "}\n"));
}

TEST(Declare, ForLanesLimbsFoldInTheSameWay) {
  const Steps plain_steps{{}, 0};  // in the frames of the document
  const auto program = [&](const Model& model, Formulated formulated) {
    Formulations formulations(*model.robot(), plain_steps.formulation());
    return traced(declare(model, {"inverse_dynamics"}).list.at(0), formulations.of(formulated)).program;
  };
  const Model different = two_arms("(0.5, 0.01, 0.0)"), same = two_arms("(0.5, 0.0, 0.0)");
  const symbolic::Program plain = program(different, Formulated::searched);
  const symbolic::Program congruent = program(different, Formulated::for_lanes);
  EXPECT_FALSE(algorithm::folds_like_others(plain));
  EXPECT_FALSE(algorithm::folds_like_others(program(same, Formulated::for_lanes)));
  ASSERT_TRUE(algorithm::folds_like_others(congruent));
  // The forces are the same, from a program that folds less.
  EXPECT_GT(symbolic::work(congruent), symbolic::work(plain));
  const symbolic::Arrays<double> state = {{"q", {0.3, -0.8}}, {"qd", {1.0, 2.0}}, {"qdd", {-3.0, 0.5}}};
  const auto expected = symbolic::interpret<double>(plain, state).at("tau");
  const auto found = symbolic::interpret<double>(congruent, state).at("tau");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t j = 0; j < found.size(); ++j) EXPECT_NEAR(found[j], expected[j], 1e-13);
}

TEST(Declare, RefusesRobotsWithThousandsOfJoints) {
  Robot robot;
  robot.tree.name = "worm";
  robot.tree.links.resize(1);
  robot.tree.joints.resize(static_cast<std::size_t>(kMaxJoints));
  EXPECT_NO_THROW(require_traceable({robot}));
  robot.tree.joints.emplace_back();
  Model model = {robot};
  model.file = "worm.urdf";
  try {
    require_traceable(model);
    FAIL() << "no Failure";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.status, wrong_input);
    EXPECT_EQ(failure.message.find("worm.urdf: error: robot 'worm' has 1001 joints"), 0U) << failure.message;
  }
}

}  // namespace
}  // namespace robcogen::driver::declare_test
