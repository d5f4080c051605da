// Loops that share joints: whether formulas close all of them depends on which joints follow in each.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "document_tree.h"
#include "interpreted_robot.h"

namespace robcogen::numeric::chained_loops_test {
namespace {

using model::KinematicTree;
using Method = model::Closure::Method;

// A joint and its link share a name; the link has the prefix `l`. Each link carries the next one, and a frame `end`.
std::string link(int id, const std::string& name, const std::string& next, double length, const std::string& frames) {
  return fmt::format(
      "link l{} {{ id = {} inertia_params {{ mass = 1.1 CoM = (0.12, 0.03, 0.02) Ix = 0.06 Iy = 0.065 Iz = 0.07 "
      "Ixy = 0.001 Ixz = -0.002 Iyz = 0.0015 }} children {{ {} }} frames {{ end_{} {{ translation = ({:.2f}, 0.0, 0.0) "
      "rotation = (0.0, 0.0, 0.0) }} {} }} }} ",
      name, id, next.empty() ? "" : fmt::format("l{0} via {0}", next), name, length, frames);
}

std::string joint(const std::string& name, double along, double angle, const std::string& more = "") {
  return fmt::format(
      "r_joint {} {{ ref_frame {{ translation = ({:.2f}, 0.0, 0.0) rotation = (0.0, 0.0, {:.2f}) }} {} }} ", name,
      along, angle, more);
}

// A crank a, a rod b and a rocker c; the rocker drives a second rocker e through a rod d. The crank has a motor.
std::string two_four_bars(const std::string& leader) {
  return "Robot Chain { RobotBase base { children { la via a lc via c le via e } } " + link(1, "a", "b", 0.2, "") +
         link(2, "b", "", 0.55, "") + link(3, "c", "d", 0.4, "") + link(4, "d", "", 0.45, "") +
         link(5, "e", "", 0.35, "") + joint("a", 0.0, 1.2, "armature = 0.1") + joint("b", 0.2, -0.8) +
         joint("c", 0.5, 1.4) + joint("d", 0.3, -1.2) + joint("e", 1.0, 1.5) +
         "loops { first { frames = end_b ~ end_c type = hinge } second { frames = end_d ~ end_e type = hinge } } " +
         leader + "}";
}

std::vector<std::string> names_of(const KinematicTree& tree, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int j : joints) names.push_back(tree.joints[static_cast<std::size_t>(j)].name);
  return names;
}

class ChainedLoops : public testing::TestWithParam<std::string> {};

// When d is the coordinate, b and c must not both follow in the first loop, although only a has a motor there.
TEST_P(ChainedLoops, CloseByFormulas) {
  const KinematicTree tree = tree_of_text(two_four_bars("independent { " + GetParam() + " } "));
  EXPECT_EQ(names_of(tree, tree.coordinates()), std::vector<std::string>{GetParam()});
  ASSERT_EQ(tree.closures.size(), 2U);
  for (const model::Closure& closure : tree.closures) EXPECT_EQ(closure.method, Method::planar);
  EXPECT_EQ(check_all(InterpretedRobot(tree, model::all_desired(tree)), 5, 3).failure_report(), "");
}

INSTANTIATE_TEST_SUITE_P(
    ,
    ChainedLoops,
    testing::Values("a", "b", "c", "d", "e"),
    [](const testing::TestParamInfo<std::string>& of) { return of.param; });

// Both loops contain x and y, and t is the coordinate: until the first loop is closed, no three joints of the second
// one are known.
TEST(LoopsThatWaitForOneAnother, CloseTogether) {
  const std::string text =
      "Robot Ring { RobotBase base { children { lx via x lp via p ls via s } } " + link(1, "x", "y", 0.3, "") +
      link(2, "y", "", 0.3, "middle { translation = (0.15, 0.05, 0.0) rotation = (0.0, 0.0, 0.0) }") +
      link(3, "p", "", 0.35, "") + link(4, "s", "t", 0.25, "") + link(5, "t", "", 0.35, "") + joint("x", 0.0, 1.3) +
      joint("y", 0.3, -0.9) + joint("p", 0.4, 1.5) + joint("s", 0.8, 1.6) + joint("t", 0.25, 0.6) +
      "loops { first { frames = middle ~ end_p type = hinge } second { frames = end_y ~ end_t type = hinge } } "
      "independent { t } }";
  const KinematicTree tree = tree_of_text(text);
  ASSERT_EQ(tree.closures.size(), 1U);
  EXPECT_EQ(tree.closures.front().method, Method::iterative);
  EXPECT_EQ(check_all(InterpretedRobot(tree, model::all_desired(tree)), 5, 3).failure_report(), "");
}

}  // namespace
}  // namespace robcogen::numeric::chained_loops_test
