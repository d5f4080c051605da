// The modules of every robot, and of transforms without a robot, run by Node.
#include "node.h"

namespace robcogen::test::robots_test {
namespace {

std::filesystem::path document(const std::string& robot) {
  return std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / robot / (robot + ".kindsl");
}

class JavaScriptRobots : public WithNode, public testing::WithParamInterface<std::string> {};

TEST_P(JavaScriptRobots, GiveWhatTheInterpreterGives) {
  // Tracing large robots takes long.
  const std::vector<std::string> groups = GetParam() == "humanoid"
                                              ? std::vector<std::string>{"inverse_dynamics", "joint_space_inertia"}
                                          : GetParam() == "centaur" ? algorithm::default_groups()
                                                                    : algorithm::groups();
  const backend::Library library = library_of(document(GetParam()), GetParam(), std::nullopt, {}, groups);
  int calls = 0;
  EXPECT_EQ(differences(library, module_of(library), &calls), "");
  EXPECT_GE(calls, 12);
}

const std::string kRobots[] = {
    "hyl_parametric",
    "ball_leg",
    "five_bar",
#if ROBCOGEN_TEST_EVERYTHING
    "hyl",
    "scara",
    "achilles_leg",
    "centaur",
    "delta",
    "gripper",
    "humanoid",
    "iiwa14",
    "puma560",
    "quadruped",
    "quadruped_fixed",
    "tree5",
#endif
};
INSTANTIATE_TEST_SUITE_P(Of, JavaScriptRobots, testing::ValuesIn(kRobots), [](const auto& robot) {
  return robot.param;
});

class JavaScript : public WithNode {};

TEST_F(JavaScript, ColumnsSolvedInALoopAreThoseWrittenOut) {
  const ColumnLoopLibraries libraries = column_loop_libraries("hexapod");
  const OutputFile module = module_of(libraries.in_loops);
  ASSERT_NE(module.text.find("$solve($results.d_qdd, 18, "), std::string::npos);
  ASSERT_NE(module.text.find("$solve($results.d_tau, 18, "), std::string::npos);
  EXPECT_EQ(differences(libraries.written_out, module), "");
}

TEST_F(JavaScript, TransformsWithNoRobotGiveWhatTheInterpreterGives) {
  const backend::Library euler =
      library_of(std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl", "euler");
  ASSERT_GT(euler.functions.size(), 5U);
  EXPECT_EQ(differences(euler, module_of(euler)), "");
}

TEST_F(JavaScript, WithOneSignWrongIsFoundOut) {
  const backend::Library hyl = library_of(document("hyl"), "hyl");
  OutputFile wrong = module_of(hyl);
  const std::size_t function = wrong.text.find("export function forward_dynamics(");
  ASSERT_NE(function, std::string::npos);
  wrong.text[wrong.text.find(" - ", function) + 1] = '+';
  const std::string report = differences(hyl, wrong);
  EXPECT_EQ(report.find("robot.forward_dynamics: element 0 is "), 0U) << report;
  EXPECT_EQ(report.find("robot.inverse"), std::string::npos) << report;
}

// Derivatives with respect to parameters are matrices, and derivatives of matrices are lists of columns.
TEST_F(JavaScript, DerivativesGiveWhatTheInterpreterGives) {
  backend::Library leg = library_of(
      document("hyl_parametric"), "leg", std::nullopt,
      {{"inverse_dynamics", {"q", "parameters"}}, {"transforms.homogeneous.fr_base_X_fr_foot", {"q"}}});
  std::erase_if(leg.functions, [](const backend::Function& f) { return f.derivatives.empty(); });
  ASSERT_GT(leg.functions.size(), 0U);
  EXPECT_EQ(differences(leg, module_of(leg)), "");
}

}  // namespace
}  // namespace robcogen::test::robots_test
