// From models to programs.
#include "driver/trace.h"

#include <cmath>

#include "documents.h"
#include "driver/failure.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"

namespace robcogen::driver {
namespace {

using namespace test;

TEST(Trace, MakesTheFunctionsOfEachGroupInTurn) {
  const Functions functions = trace(rods(), {"joint_space_inertia", "inverse_dynamics"}, {});
  ASSERT_GE(functions.list.size(), 3U);  // one inertia matrix, and inverse dynamics with several loads
  EXPECT_EQ(functions.list.front().traced.group, "joint_space_inertia");
  for (std::size_t i = 1; i < functions.list.size(); ++i) {
    EXPECT_EQ(functions.list[i].traced.group, "inverse_dynamics");
    EXPECT_EQ(functions.list[i].transform, -1);
  }
}

// Weights by hand: both masses about the shoulder, the second one about the elbow.
TEST(Trace, ComputesWhatTheRobotDoes) {
  const double q1 = 0.4, q2 = -1.1;
  for (const std::vector<std::string>& steps : {std::vector<std::string>(), all_steps()}) {
    const Functions functions = trace(rods(), {"inverse_dynamics"}, {steps});
    const auto tau = symbolic::interpret<double>(functions.list.at(0).traced.program, {{"q", {q1, q2}}}).at("tau");
    const double second = kGravity * kM2 * kL2 * std::cos(q1 + q2);
    EXPECT_NEAR(tau[0], kGravity * (kM1 + kM2) * kL1 * std::cos(q1) + second, 1e-13);
    EXPECT_NEAR(tau[1], second, 1e-13);
  }
}

TEST(Trace, OfTransformsKnowsWhichOneEachFunctionIs) {
  const Folder folder;
  const Model model = loaded(folder.file("arm.motdsl", kMotions));
  const Functions functions = trace_for_lanes(model, {kTransformsGroup}, {});
  const auto& transforms = model.transforms()->document.transforms;
  EXPECT_EQ(functions.list.size(), 3 * transforms.size());  // homogeneous, motion, force
  for (const Function& f : functions.list) {
    EXPECT_EQ(f.traced.group, kTransformsGroup);
    ASSERT_GE(f.transform, 0);
    const model::CoordinateTransform& t = transforms.at(static_cast<std::size_t>(f.transform));
    EXPECT_EQ(f.traced.name, t.left + "_X_" + t.right);
    EXPECT_FALSE(f.congruent);
  }
}

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

TEST(Trace, ForLanesLimbsFoldInTheSameWay) {
  const Steps plain_steps{{}, 0};  // in the frames of the document
  const std::vector<std::string> groups = {"inverse_dynamics"};
  const auto congruent = [&](const Model& model) {
    return trace_for_lanes(model, groups, plain_steps).list.at(0).congruent;
  };
  const Model different = two_arms("(0.5, 0.01, 0.0)");
  EXPECT_FALSE(trace(different, groups, plain_steps).list.at(0).congruent);
  EXPECT_FALSE(congruent(two_arms("(0.5, 0.0, 0.0)")));
  const auto program = congruent(different);
  ASSERT_TRUE(program);
  // The forces are the same, from a program that folds less.
  const symbolic::Program plain = trace(different, groups, plain_steps).list.at(0).traced.program;
  EXPECT_GT(symbolic::work(*program), symbolic::work(plain));
  const symbolic::Arrays<double> state = {{"q", {0.3, -0.8}}, {"qd", {1.0, 2.0}}, {"qdd", {-3.0, 0.5}}};
  const auto expected = symbolic::interpret<double>(plain, state).at("tau");
  const auto found = symbolic::interpret<double>(*program, state).at("tau");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t j = 0; j < found.size(); ++j) EXPECT_NEAR(found[j], expected[j], 1e-13);
}

TEST(Trace, RefusesRobotsWithThousandsOfJoints) {
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
}  // namespace robcogen::driver
