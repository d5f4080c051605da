// The text of every robot, and of transforms without a robot, run by Maxima on numbers.
#include <fmt/format.h>

#include <set>

#include "maxima.h"
#include "patterns.h"

namespace robcogen::test::robots_test {
namespace {

constexpr std::size_t kColumns = 100;

std::filesystem::path document(const std::string& robot) {
  return std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / robot / (robot + ".kindsl");
}

class MaximaRobots : public WithMaxima, public testing::WithParamInterface<std::string> {};

TEST_P(MaximaRobots, GiveWhatTheInterpreterGives) {
  // Maxima takes a minute for the derivatives of a humanoid, and half a minute for those of a centaur. In the default
  // run the robot with parameters stands for the groups.
  const bool has_all =
      ROBCOGEN_TEST_EVERYTHING ? GetParam() != "humanoid" && GetParam() != "centaur" : GetParam() == "hyl_parametric";
  const backend::Library library = library_of(
      document(GetParam()), GetParam(), std::nullopt, {}, has_all ? algorithm::groups() : algorithm::default_groups());
  ASSERT_GT(library.functions.size(), 20U);
  EXPECT_EQ(differences(library, maxima_text(library)), "");
}

#if ROBCOGEN_TEST_EVERYTHING
TEST_F(WithMaxima, TransformsWithNoRobotGiveWhatTheInterpreterGives) {
  const backend::Library euler =
      library_of(std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl", "euler");
  ASSERT_GT(euler.functions.size(), 5U);
  EXPECT_EQ(differences(euler, maxima_text(euler)), "");
}
#endif

TEST_F(WithMaxima, DerivativesGiveWhatTheInterpreterGives) {
  const backend::Library leg = library_of(
      document("hyl_parametric"), "leg", model::MovedFramePosition::left,
      {{"inverse_dynamics", {"q", "parameters"}}, {"transforms.homogeneous.fr_base_X_fr_foot", {"q"}}});
  const backend::Library euler = library_of(
      std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / "euler" / "euler.motdsl", "euler", std::nullopt,
      {{"transforms.motion.S_X_zyx", {"variables"}}});
  for (backend::Library library : {leg, euler}) {
    std::erase_if(library.functions, [](const backend::Function& f) { return f.derivatives.empty(); });
    ASSERT_GT(library.functions.size(), 0U);
    EXPECT_EQ(differences(library, maxima_text(library)), "");
  }
}

#if ROBCOGEN_TEST_EVERYTHING
TEST_F(WithMaxima, ColumnsSolvedInALoopAreThoseWrittenOut) {
  ColumnLoopLibraries libraries = column_loop_libraries("quadruped");
  for (backend::Library* library : {&libraries.in_loops, &libraries.written_out})
    std::erase_if(library->functions, [](const backend::Function& f) {  // Maxima takes seconds for each function
      return f.kernel != "forward_dynamics_derivatives";
    });
  const OutputFile text = maxima_text(libraries.in_loops);
  ASSERT_NE(text.text.find("forward_dynamics_derivatives_columns(factor, 3, "), std::string::npos);
  EXPECT_EQ(differences(libraries.written_out, text), "");
}
#endif

class MaximaText : public testing::TestWithParam<std::string> {};

TEST_P(MaximaText, IsTidy) {
  const std::string text =
      maxima_text(library_of(document(GetParam()), GetParam(), model::MovedFramePosition::left)).text;
  std::set<std::string> names;
  std::size_t definitions = 0, begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    ASSERT_NE(end, std::string::npos) << "no end of line at the end";
    const std::string line = text.substr(begin, end - begin);
    EXPECT_LE(line.size(), kColumns) << line;
    EXPECT_EQ(line.find('\t'), std::string::npos) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
    if (line.starts_with(GetParam() + "_")) {
      ++definitions;
      names.insert(line.substr(0, line.find('(')));
    }
    begin = end + 1;
  }
  EXPECT_GT(definitions, 20U);
  EXPECT_EQ(names.size(), definitions) << "a name is defined twice";
}

const std::string kRobots[] = {
    "hyl_parametric",
#if ROBCOGEN_TEST_EVERYTHING
    "ball_leg",
    "hyl",
    "achilles_leg",
    "centaur",
    "five_bar",
    "humanoid",
    "iiwa14",
    "puma560",
    "quadruped",
    "quadruped_fixed",
    "scara",
    "tree5",
#endif
};
std::string itself(const testing::TestParamInfo<std::string>& robot) {
  return robot.param;
}
INSTANTIATE_TEST_SUITE_P(Of, MaximaRobots, testing::ValuesIn(kRobots), itself);
INSTANTIATE_TEST_SUITE_P(Of, MaximaText, testing::ValuesIn(kRobots), itself);

class MaximaRobot : public WithMaxima {
 protected:
  const backend::Library hyl_ = library_of(document("hyl"), "hyl");
  const OutputFile text_ = maxima_text(hyl_);
};

TEST_F(MaximaRobot, WithOneSignWrongIsFoundOut) {
  OutputFile wrong = text_;
  const std::size_t function = wrong.text.find("hyl_forward_dynamics_external(");
  ASSERT_NE(function, std::string::npos);
  const std::size_t sign = wrong.text.find(" - ", function);
  wrong.text[sign + 1] = '+';
  const std::string report = differences(hyl_, wrong);
  EXPECT_EQ(report.find("hyl_forward_dynamics_external: element 0 is "), 0U) << report;
  EXPECT_EQ(report.find("hyl_inverse"), std::string::npos) << report;
}

#if ROBCOGEN_TEST_EVERYTHING
// With a floating base, gravity says how the base is oriented. Maxima functions have no defaults, so they cannot be
// called without it.
TEST_F(MaximaRobot, ThatFloatsTakesGravity) {
  const backend::Library library =
      library_of(std::filesystem::path(TEST_SOURCE_DIR) / "../octave/parametric.kindsl", "floating");
  ASSERT_TRUE(library.tree.floating_base);
  std::string calls;
  std::set<std::string> names;
  for (const backend::Function& f : library.functions) {
    std::string arguments;
    for (const symbolic::InputArray& input : f.program.inputs) {
      if (input.role == symbolic::Role::gravity) {
        calls += fmt::format("print(\"=\", errcatch(floating_{}({})))$\n", f.kernel, arguments);
        names.insert(f.name);
      }
      arguments += arguments.empty() ? "[]" : ", []";
    }
  }
  EXPECT_EQ(
      names, (std::set<std::string>{
                 "base_regressor", "bias_forces", "energy_regressor", "forward_dynamics",
                 "forward_dynamics_derivatives", "generalized_momentum", "gravity_forces", "gravity_forces_derivative",
                 "inverse_dynamics", "inverse_dynamics_derivatives", "inverse_dynamics_fully_actuated",
                 "inverse_dynamics_fully_actuated_derivatives", "inverse_dynamics_gradient",
                 "inverse_dynamics_second_derivatives", "potential_energy", "regressor", "slotine_li_regressor"}));
  const std::vector<std::string> lines = run_maxima({maxima_text(library), {"calls.mac", calls}});
  EXPECT_EQ(lines.size(), 26U);
  for (const std::string& line : lines) EXPECT_EQ(line, "[]");
}

// The text defines its functions and no other variable, array, option or property, and the user's definitions do not
// affect it.
TEST_F(MaximaRobot, LeavesNoTraceAndTakesNoNotice) {
  const std::string state =
      "print(\"= system\", values, arrays, myoptions, rules, aliases, macros, structures, gradefs, dependencies)$\n"
      "print(\"=\", float(hyl_joint_space_inertia([0.1, 0.2, 0.3])[1][2]))$\n";
  const OutputFile before = {"before.mac", "hyl_joint_space_inertia(q) := matrix([1, 2])$\n" + state};
  const OutputFile loaded = {"loaded.mac", state};
  const OutputFile disturbed = {
      "disturbed.mac",
      "q: 7$ q[2]: 8$ s_HFE: 9$ c_HFE: 10$ q__2: 11$\n"
      "print(\"=\", float(hyl_joint_space_inertia([0.1, 0.2, 0.3])[1][2]))$\n"
      "print(\"=\", hyl_homogeneous_fr_base_X_fr_upperleg([s_HFE, 'c_HFE, 0])[1])$\n"};
  const std::vector<std::string> lines = run_maxima({before, text_, loaded, disturbed});
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[2], lines[0]);
  EXPECT_NE(lines[3], lines[1]);
  EXPECT_EQ(lines[4], lines[3]);
  EXPECT_EQ(lines[5], "[- sin(c_HFE), - cos(c_HFE), 0, 0]");
}

TEST_F(MaximaRobot, NamesNoVariableOfTheSystem) {
  std::set<std::string> names;
  for (const std::string& robot : kRobots) {
    const std::string text = maxima_text(library_of(document(robot), robot)).text;
    for (const Match& definition : all_matches(text, "\n  (\\w+): |[(] ?(\\w+)(?:, (\\w+))*[)] := "))
      for (std::size_t group = 1; group < definition.size(); ++group)
        if (!definition[group].empty()) names.insert(definition[group]);
  }
  ASSERT_GT(names.size(), 100U);
  ASSERT_EQ(names.count("tau") + names.count("q") + names.count("s_HFE"), 3U);
  const std::string check = fmt::format(
      "for s in '[{}, numer] do if apply('properties, [s]) # [] then print(\"=\", s)$\n", fmt::join(names, ", "));
  EXPECT_EQ(run_maxima({{"check.mac", check}}), std::vector<std::string>{"numer"});
}
#endif

}  // namespace
}  // namespace robcogen::test::robots_test
