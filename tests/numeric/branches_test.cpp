// Loops assembled in their other branch, compared with the reference and with the same robot drawn in that position.
#include <gtest/gtest.h>

#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "robcogen/reference/samples.h"

namespace robcogen::numeric::branches_test {
namespace {

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  const std::string digits = text;
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string body(int id, const std::string& content) {
  return " id = " + std::to_string(id) +
         " inertia_params { mass = 1.3 CoM = (0.12, 0.03, 0.02) Ix = 0.06 Iy = 0.065 Iz = 0.07 Ixy = 0.001 Ixz = "
         "-0.002 "
         "Iyz = 0.0015 } " +
         content;
}

std::string frame(const std::string& name, const std::string& translation, const std::string& rotation) {
  return name + " { translation = (" + translation + ") rotation = (" + rotation + ") } ";
}

// Returns the document of a mechanism whose followers are offset by `first` and `second` at q = 0.
using Drawing = std::string (*)(double first, double second, const std::string& branch);

std::string four_bar(double first, double second, const std::string& branch) {
  return "Robot Bar { RobotBase base { children { crank via a rocker via c } } link crank {" +
         body(1, "children { rod via b }") + "} link rod {" +
         body(2, "children {} frames { " + frame("end", "0.55, 0.0, 0.0", "0.0, 0.0, 0.0") + "}") + "} link rocker {" +
         body(3, "children {} frames { " + frame("pin", "0.4, 0.0, 0.0", "0.0, 0.0, 0.0") + "}") + "} r_joint a { " +
         frame("ref_frame", "0.0, 0.0, 0.0", "0.0, 0.0, 1.2") + "} r_joint b { " +
         frame("ref_frame", "0.2, 0.0, 0.0", "0.0, 0.0, " + number(first - 0.8)) + "} r_joint c { " +
         frame("ref_frame", "0.5, 0.0, 0.0", "0.0, 0.0, " + number(second + 1.4)) +
         "} loops { bar { frames = end ~ pin type = hinge" + branch + " } } independent { a } }";
}

std::string slider_crank(double first, double second, const std::string& branch) {
  return "Robot Crank { RobotBase base { children { crank via a piston via c } } link crank {" +
         body(1, "children { rod via b }") + "} link rod {" +
         body(2, "children {} frames { " + frame("end", "0.45, 0.0, 0.0", "0.0, 0.0, 0.0") + "}") + "} link piston {" +
         body(3, "children {} frames { " + frame("pin", "0.0, 0.0, 0.0", "0.0, -PI/2.0, 0.0") + "}") +
         "} r_joint a { " + frame("ref_frame", "0.0, 0.0, 0.0", "0.0, 0.0, 1.0") + "} r_joint b { " +
         frame("ref_frame", "0.2, 0.0, 0.0", "0.0, 0.0, " + number(first - 1.4)) + "} p_joint c { " +
         frame("ref_frame", number(second + 0.5) + ", 0.0, 0.0", "0.0, PI/2.0, 0.0") +
         "} loops { bar { frames = end ~ pin type = hinge" + branch + " } } independent { a } }";
}

std::string rod(double first, double, const std::string& branch) {
  return "Robot Rod { RobotBase base { children { crank via a rocker via c } } link crank {" +
         body(1, "children {} frames { " + frame("end", "0.2, 0.0, 0.1", "0.0, 0.0, 0.0") + "}") + "} link rocker {" +
         body(2, "children {} frames { " + frame("pin", "0.4, 0.0, 0.0", "0.0, 0.0, 0.0") + "}") + "} r_joint a { " +
         frame("ref_frame", "0.0, 0.0, 0.0", "0.1, 0.2, 1.2") + "} r_joint c { " +
         frame("ref_frame", "0.5, 0.0, 0.0", "0.0, 0.0, " + number(first + 1.4)) +
         "} loops { bar { frames = end ~ pin distance = 0.55" + branch + " } } independent { a } }";
}

model::KinematicTree tree_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("bar.kindsl", text);
  auto tree = import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics);
  EXPECT_EQ(diagnostics.error_count(), 0U) << diagnostics.render() << text;
  if (!tree) throw std::runtime_error("the robot is refused");
  return *std::move(tree);
}

// Returns the assembled positions of the followers, in the order of the document.
std::vector<double> assembled(const model::KinematicTree& tree) {
  std::vector<double> positions;
  for (const model::Coupling& coupling : tree.couplings) positions.push_back(model::evaluate(coupling.offset));
  positions.resize(2);
  return positions;
}

class Branches : public testing::TestWithParam<Drawing> {};

TEST_P(Branches, CloseInTwoWays) {
  const model::KinematicTree drawn = tree_of(GetParam()(0, 0, "")),
                             other = tree_of(GetParam()(0, 0, " branch = other"));
  ASSERT_EQ(drawn.closures.size(), 1U);
  ASSERT_EQ(other.closures.size(), 1U);
  EXPECT_EQ(other.closures.front().branch, -drawn.closures.front().branch);
  EXPECT_EQ(tree_of(GetParam()(0, 0, " branch = drawn")).closures.front().branch, drawn.closures.front().branch);
  // The two branches are far apart.
  EXPECT_GT(std::abs(assembled(other)[0] - assembled(drawn)[0]), 0.3);
}

TEST_P(Branches, AgreeWithTheReference) {
  const model::KinematicTree tree = tree_of(GetParam()(0, 0, " branch = other"));
  EXPECT_EQ(check_all(InterpretedRobot(tree, model::all_desired(tree)), 7, 4).failure_report(), "");
}

TEST_P(Branches, MoveAsIfDrawnThere) {
  const model::KinematicTree other = tree_of(GetParam()(0, 0, " branch = other"));
  const std::vector<double> there = assembled(other);
  const model::KinematicTree moved = tree_of(GetParam()(there[0], there[1], ""));
  EXPECT_LT(std::abs(assembled(moved)[0]) + std::abs(assembled(moved)[1]), 1e-9);
  const InterpretedRobot a(other, {}), b(moved, {});
  for (const double q : {-0.2, 0.0, 0.15}) {
    const symbolic::Arrays<double> inputs = {{"q", {q}}, {"qd", {0.7}}, {"qdd", {-1.1}}, {"tau", {2.0}}};
    for (const auto& [function, result] :
         {std::pair("inverse_dynamics", "tau"), {"forward_dynamics", "qdd"}, {"joint_space_inertia", "H"}}) {
      const double wanted = b.run(function, {}, inputs).at(result)[0];
      EXPECT_NEAR(a.run(function, {}, inputs).at(result)[0], wanted, 1e-9 * (1 + std::abs(wanted))) << function;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    ,
    Branches,
    testing::Values(four_bar, slider_crank, rod),
    [](const testing::TestParamInfo<Drawing>& of) {
      return std::string(of.index == 0 ? "four_bar" : of.index == 1 ? "slider_crank" : "rod");
    });

}  // namespace
}  // namespace robcogen::numeric::branches_test
