// Operation counts must not rise: bounds that the cheap forms of the algorithms reached, as mul/add/div (instructions).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_tool.h"

namespace robcogen::test::operations_test {
namespace {

struct Bound {
  const char* function;
  int mul, add, div, instructions;
  int sqrt = 0;
};

void expect_within(const std::filesystem::path& model, const std::vector<Bound>& bounds) {
  const Outcome run = run_tool("ops --json " + quoted(model));
  ASSERT_EQ(run.status, 0) << run.errors;
  const nlohmann::json functions = nlohmann::json::parse(run.output)["functions"];
  for (const Bound& bound : bounds) {
    bool found = false;
    for (const nlohmann::json& f : functions) {
      if (f["name"] != bound.function) continue;
      found = true;
      EXPECT_LE(f["mul"].get<int>(), bound.mul) << bound.function;
      EXPECT_LE(f["add"].get<int>(), bound.add) << bound.function;
      EXPECT_LE(f["div"].get<int>(), bound.div) << bound.function;
      EXPECT_LE(f["instructions"].get<int>(), bound.instructions) << bound.function;
      EXPECT_LE(f["sqrt"].get<int>(), bound.sqrt) << bound.function;
    }
    EXPECT_TRUE(found) << bound.function;
  }
}

std::filesystem::path ill(const std::string& name) {
  return std::filesystem::path(TEST_SOURCE_DIR) / "../../numeric/ill" / (name + ".kindsl");
}

TEST(Operations, RoundingErrorsStandBesideThem) {
  const Outcome run = run_tool("ops --algorithms inverse_dynamics --json " + quoted(ill("near_parallel")));
  ASSERT_EQ(run.status, 0) << run.errors;
  for (const nlohmann::json& f : nlohmann::json::parse(run.output)["functions"]) {
    EXPECT_LT(f["rounding"]["double"].get<double>(), 50) << f["name"];
    EXPECT_LT(f["rounding"]["float"].get<double>(), 50) << f["name"];
  }
  const Outcome table = run_tool("ops " + quoted(ill("near_parallel")));
  EXPECT_NE(table.output.find("double error"), std::string::npos) << table.output;
}

TEST(Operations, OfEachChoiceAloneOfNearlyParallelAxes) {
  for (const char* choice : {"base-parameters", "choose-fd", "frames", "turn-inertia", "reverse-mode"}) {
    const Outcome run = run_tool(std::string("ops --passes ") + choice + " " + quoted(ill("nearly_planar")));
    EXPECT_EQ(run.status, 0) << choice << "\n" << run.errors;
  }
}

// With lanes, functions are named together with the limbs that share them, or with the reason why none do.
TEST(Operations, SayWhichLimbsShareLanes) {
  const std::string options = " --effort 0 --algorithms inverse_dynamics,energy ", file = quoted(robot("two_arms"));
  const Outcome table = run_tool("ops --lanes" + options + file);
  ASSERT_EQ(table.status, 0) << table.errors;
  for (const char* line :
       {"\nlimbs of left_swing, right_swing share lanes: inverse_dynamics\n",
        "\nno limbs share lanes, because lanes would not be clearly faster: kinetic_energy, potential_energy\n"})
    EXPECT_NE(table.output.find(line), std::string::npos) << table.output;
  const Outcome json = run_tool("ops --lanes --json" + options + file);
  const nlohmann::json functions = nlohmann::json::parse(json.output)["functions"];
  EXPECT_EQ(functions[0]["limbs_in_lanes"], nlohmann::json::array({"left_swing, right_swing"}));
  EXPECT_EQ(functions[1]["without_lanes"], "lanes would not be clearly faster");
  const Outcome without = run_tool("ops" + options + file);
  EXPECT_EQ(without.output.find("lanes"), std::string::npos) << without.output;
}

// The message about limbs that look alike, but are not congruent, names the first difference between them.
TEST(Operations, SayWhyLimbsShareNoLanes) {
  std::string text = "Robot pair {\nRobotBase body { children { a1 via A1  b1 via B1 } }\n", joints;
  int id = 0;
  for (const std::string limb : {"a", "b"}) {
    for (int k = 1; k <= 3; ++k) {
      const std::string place = std::to_string(k), next = limb + std::to_string(k + 1);
      const std::string child = k == 3 ? "" : next + " via " + (limb == "a" ? "A" : "B") + std::to_string(k + 1);
      text +=
          "link " + limb + place + " { id = " + std::to_string(++id) +
          "\ninertia_params { mass = 1.0 CoM = (0.1, 0.2, 0.3) Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = "
          "0.0 }\nchildren { " +
          child + " } }\n";
      joints += (limb == "b" && k == 3 ? "p_joint " : "r_joint ") + std::string(limb == "a" ? "A" : "B") + place +
                " { ref_frame { translation = (0.5, 0.0, 0.1) rotation = (0.5, 0.0, 0.0) } }\n";
    }
  }
  const Scratch scratch("unlike");
  const std::filesystem::path file = scratch.path / "pair.kindsl";
  write_text(file, text + joints + "}\n");
  const Outcome table = run_tool("ops --lanes --effort 0 --algorithms inverse_dynamics " + quoted(file));
  ASSERT_EQ(table.status, 0) << table.errors;
  EXPECT_NE(
      table.output.find("\nlimbs of A1 and B1 share no lanes: A3 is revolute, B3 is prismatic\n"), std::string::npos)
      << table.output;
  const Outcome json = run_tool("ops --lanes --json --effort 0 --algorithms inverse_dynamics " + quoted(file));
  const nlohmann::json unlike = nlohmann::json::parse(json.output)["unlike_limbs"];
  ASSERT_EQ(unlike.size(), 1U) << json.output;
  EXPECT_EQ(unlike[0]["joints"], nlohmann::json::array({"A1", "B1"}));
  EXPECT_EQ(unlike[0]["reason"], "A3 is revolute, B3 is prismatic");
}

std::filesystem::path corpus(const std::string& name) {
  return std::filesystem::path(ROBCOGEN_CORPUS_DIR) / name;
}

const std::string kHyQ = "DrawZeroPoint_control-toolbox__ct_rbd_test_models_testhyq_description_test_hyq.kindsl";
const std::string kIrb = "DrawZeroPoint_control-toolbox__ct_rbd_test_models_testIrb4600_description_testirb4600.kindsl";

TEST(Operations, FloatingHyQ) {
  if (!std::filesystem::exists(corpus(kHyQ))) GTEST_SKIP() << "no corpus";
  expect_within(
      corpus(kHyQ), {{"inverse_dynamics_fully_actuated", 617, 603, 0, 745},
                     {"joint_space_inertia", 282, 247, 0, 371},
                     {"forward_dynamics", 1243, 1153, 14, 1500}});
}

TEST(Operations, FixedHyQ) {
  if (!std::filesystem::exists(corpus(kHyQ))) GTEST_SKIP() << "no corpus";
  std::string text = read_text(corpus(kHyQ));
  const std::size_t word = text.find("floating");
  ASSERT_NE(word, std::string::npos);
  const Scratch scratch("hyq");
  write_text(scratch.path / "hyq.kindsl", text.erase(word, 8));
  expect_within(
      scratch.path / "hyq.kindsl", {{"inverse_dynamics", 302, 202, 0, 318},
                                    {"joint_space_inertia", 82, 70, 0, 104},
                                    {"forward_dynamics", 314, 222, 8, 370}});
}

// The moments of this robot's first link are negative, so that H is nearly singular in some states. Sums in the order
// that fuses most then lose too many digits, so forward dynamics keeps its traced order.
TEST(Operations, Irb4600) {
  if (!std::filesystem::exists(corpus(kIrb))) GTEST_SKIP() << "no corpus";
  expect_within(
      corpus(kIrb), {{"inverse_dynamics", 199, 164, 0, 226},
                     {"joint_space_inertia", 126, 93, 0, 151},
                     {"forward_dynamics", 378, 281, 5, 440}});
}

// The HyL of this project, counted by hand: two sincos, and no divisions except those of the articulated inertias.
TEST(Operations, OurRobots) {
  expect_within(
      robot("hyl"),
      {{"inverse_dynamics", 26, 19, 0, 30}, {"joint_space_inertia", 8, 6, 0, 10}, {"forward_dynamics", 42, 33, 2, 51}});
}

TEST(Operations, OfGroups) {
  const Outcome run = run_tool("ops --json --algorithms energy,inverse_dynamics -- " + quoted(robot("hyl")));
  ASSERT_EQ(run.status, 0) << run.errors;
  std::vector<std::string> names;
  const nlohmann::json report = nlohmann::json::parse(run.output);
  for (const nlohmann::json& f : report["functions"]) names.push_back(f["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"inverse_dynamics", "kinetic_energy", "potential_energy"}));
  EXPECT_EQ(run_tool("ops --algorithms walking -- " + quoted(robot("hyl"))).status, 2);
}

// A class of such legs: operations that depend only on parameters count with the updates.
TEST(Operations, RobotsWithParameters) {
  expect_within(
      robot("hyl_parametric"), {{"inverse_dynamics", 33, 24, 0, 36},
                                {"joint_space_inertia", 14, 14, 0, 21},
                                {"forward_dynamics", 66, 49, 2, 82},
                                {"update_kinematics", 10, 10, 0, 20},
                                {"update_dynamics", 60, 60, 10, 100},
                                {"update_both", 40, 40, 10, 60, 1}});
}

}  // namespace
}  // namespace robcogen::test::operations_test
