// Loops of trees: which joints follow, how loops are assembled, and how they are printed.
#include <gtest/gtest.h>

#include "coupling_sums.h"
#include "export/kinematics.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "language/kinematics/document.h"

namespace robcogen::test::loops_test {
namespace {

// A crank, a rod and a rocker; `more` is added to the robot.
std::string four_bar(const std::string& more, const std::string& rod = "-0.8", const std::string& rocker = "1.4") {
  return "Robot FourBar { RobotBase base { children { crank via a rocker via c } } "
         "link crank { id = 1 children { rod via b } } "
         "link rod { id = 2 children {} frames { end { translation = (0.55, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } "
         "link rocker { id = 3 children {} frames { pin { translation = (0.4, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } "
         "} "
         "r_joint a { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 1.2) } } "
         "r_joint b { ref_frame { translation = (0.2, 0.0, 0.0) rotation = (0.0, 0.0, " +
         rod + ") } } r_joint c { ref_frame { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, " + rocker +
         ") } } "
         "loops { bar { frames = end ~ pin type = hinge } } " +
         more + "}";
}

model::KinematicTree tree_of(const std::string& text) {
  Diagnostics diagnostics;
  auto tree = import::kinematic_tree(
      language::kinematics::parse(std::make_shared<const Source>("four_bar.kindsl", text), diagnostics), diagnostics);
  EXPECT_TRUE(tree) << diagnostics.render();
  return *tree;
}

std::vector<std::string> coordinates(const model::KinematicTree& tree) {
  std::vector<std::string> names;
  for (const int joint : tree.coordinates()) names.push_back(tree.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

using Names = std::vector<std::string>;

TEST(Loops, TheLastJointsFollowUnlessOthersAreAskedForOrDriven) {
  EXPECT_EQ(coordinates(tree_of(four_bar(""))), Names{"a"});
  EXPECT_EQ(coordinates(tree_of(four_bar("independent { c }"))), Names{"c"});
  EXPECT_EQ(coordinates(tree_of(four_bar("independent { b }"))), Names{"b"});
  std::string text = four_bar("");
  text.replace(text.find("rotation = (0.0, 0.0, 1.4) }"), 28, "rotation = (0.0, 0.0, 1.4) } armature = 0.1");
  EXPECT_EQ(coordinates(tree_of(text)), Names{"c"});
}

// Drawn with the elbow up or down, the loop has the same sides, mirrored.
TEST(Loops, AreAssembledAsTheyAreDrawn) {
  const model::KinematicTree up = tree_of(four_bar("")), down = tree_of(four_bar("", "-2.2", "-1.9"));
  ASSERT_EQ(up.closures.size(), 1U);
  ASSERT_EQ(down.closures.size(), 1U);
  EXPECT_EQ(up.closures[0].branch, -down.closures[0].branch);
  // The offset is the position of a following joint when the loop closes. It is not zero, because the drawn position
  // does not close the loop.
  for (const model::Coupling& coupling : up.couplings) {
    EXPECT_FALSE(coupling.is_linear());
    EXPECT_NE(model::evaluate(coupling.offset), 0.0);
    EXPECT_LT(std::abs(model::evaluate(coupling.offset)), 0.6);
  }
}

TEST(Loops, PrintAsTheyWereRead) {
  const model::KinematicTree tree = tree_of(four_bar("independent { b }"));
  const std::string text = language::kinematics::print(exporting::kinematics_document(tree));
  EXPECT_NE(text.find("bar { frames = end ~ pin type = hinge }"), std::string::npos) << text;
  EXPECT_NE(text.find("independent { b }"), std::string::npos) << text;
  EXPECT_EQ(text.find("couplings"), std::string::npos) << text;
  EXPECT_EQ(coordinates(tree_of(text)), Names{"b"});
}

// A loop with the sides crank, base and rocker. The crank is placed at `angle`, the other joints as in a parallelogram;
// `more` is added to the robot.
std::string parallelogram(
    const std::string& angle,
    const std::string& back,
    const std::string& more = "",
    const std::string& crank = "0.2",
    const std::string& rocker = "0.2") {
  return "Robot Parallelogram { RobotBase base { children { crank via a rocker via c } } "
         "link crank { id = 1 children { rod via b } } "
         "link rod { id = 2 children {} frames { end { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } "
         "link rocker { id = 3 children {} frames { pin { translation = (" +
         rocker +
         ", 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } "
         "r_joint a { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, " +
         angle + ") } } r_joint b { ref_frame { translation = (" + crank + ", 0.0, 0.0) rotation = (0.0, 0.0, " + back +
         ") } } r_joint c { ref_frame { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, " + angle +
         ") } } loops { bar { frames = end ~ pin type = hinge } } " + more + "}";
}

TEST(Parallelograms, AreSums) {
  for (const char* angle : {"1.2", "PI/2.0", "-2.0"}) {
    const std::string back = angle[0] == '-' ? angle + 1 : "-" + std::string(angle);
    const model::KinematicTree tree = tree_of(parallelogram(angle, back));
    EXPECT_TRUE(tree.closures.empty());
    EXPECT_EQ(tree.loops.size(), 1U);
    EXPECT_EQ(sums(tree), "b = -1.0 a; c = 1.0 a; ");
    EXPECT_EQ(sums(tree_of(parallelogram(angle, back, "independent { b } "))), "a = -1.0 b; c = -1.0 b; ");
    EXPECT_EQ(sums(tree_of(parallelogram(angle, back, "independent { c } "))), "a = 1.0 c; b = -1.0 c; ");
    const std::string text = language::kinematics::print(exporting::kinematics_document(tree));
    EXPECT_NE(text.find("bar { frames = end ~ pin type = hinge }"), std::string::npos) << text;
    EXPECT_EQ(text.find("couplings"), std::string::npos) << text;
  }
}

TEST(Parallelograms, HaveSidesOfEqualLength) {
  EXPECT_FALSE(tree_of(parallelogram("1.2", "-1.2", "", "0.2", "0.20000001")).closures.empty());
  EXPECT_EQ(sums(tree_of(parallelogram("1.2", "-1.2", "", "s[0.2]", "s"))), "b = -1.0 a; c = 1.0 a; ");
  EXPECT_FALSE(tree_of(parallelogram("1.2", "-1.2", "", "s[0.2]", "0.2")).closures.empty());
}

// A trapezoid that is drawn exactly closed: sides of 0.2, 0.5, 0.5 and 0.4 m.
TEST(Parallelograms, AreNoTrapezoids) {
  std::string text = parallelogram("PI/2.0", "-PI/2.0", "", "0.2", "0.5");
  text.replace(text.find("(0.5, 0.0, 0.0)"), 15, "(0.4, 0.3, 0.0)");
  const std::size_t ground = text.find("r_joint c");
  text.replace(text.find("(0.5, 0.0, 0.0)", ground), 15, "(0.4, 0.0, 0.0)");
  const model::KinematicTree tree = tree_of(text);
  EXPECT_EQ(tree.closures.size(), 1U);
  EXPECT_LT(std::abs(model::evaluate(tree.couplings.front().offset)), 1e-15);
}

// The sides have the same lengths, but the rod and the base cross.
TEST(Parallelograms, AreNotCrossed) {
  std::string crossed = parallelogram("1.2", "-2.02");
  crossed.replace(crossed.rfind("1.2"), 3, "-2.02");
  const model::KinematicTree tree = tree_of(crossed);
  EXPECT_EQ(tree.closures.size(), 1U);
  EXPECT_FALSE(tree.couplings.front().is_linear());
}

TEST(Parallelograms, FollowJointsOfCouplingsAndOfOneAnother) {
  const std::string coupled = "couplings { a = 0.5 * m + 0.1 } ";
  std::string text = parallelogram(
      "1.2", "-1.2",
      coupled +
          "r_joint m { ref_frame { translation = (0.0, 0.0, 0.0) "
          "rotation = (0.0, 0.0, 0.0) } } "
          "link motor { id = 4 children {} } ");
  text.replace(text.find("rocker via c"), 12, "rocker via c motor via m");
  const model::KinematicTree tree = tree_of(text);
  EXPECT_EQ(sums(tree), "a = 0.5 m; b = -0.5 m; c = 0.5 m; ");
  EXPECT_EQ(model::evaluate(tree.couplings[1].offset), -0.1);
}

// Each instance of the part has its own actuator, and the printed text reads back.
TEST(Actuators, OfPartsAreThoseOfEachInstance) {
  const std::string text =
      "Part Arm { root boom via lift "
      "link boom { children {} frames { head { translation = (0.9, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } } } "
      "link foot { children {} } "
      "root foot via turn "
      "r_joint lift { ref_frame { translation = (0.0, 0.0, 1.0) rotation = (PI/2.0, 0.0, 0.0) } } "
      "r_joint turn { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } "
      "actuators { cylinder { from = fr_foot to = head } } } "
      "Robot Two { RobotBase trunk { children { Arm L at { translation = (0.0, 0.2, 0.0) rotation = (0.0, 0.0, 0.0) } "
      "Arm R at { translation = (0.0, -0.2, 0.0) rotation = (0.0, 0.0, 0.0) } mirrored y } } }";
  Diagnostics diagnostics;
  const auto read = import::robot_document(std::make_shared<const Source>("two.kindsl", text), {}, diagnostics);
  ASSERT_TRUE(read) << diagnostics.render();
  const auto tree = import::kinematic_tree(read->document, diagnostics);
  ASSERT_TRUE(tree) << diagnostics.render();
  ASSERT_EQ(tree->actuators.size(), 2U);
  EXPECT_EQ(tree->actuators[1].name, "R_cylinder");
  const std::string printed = language::kinematics::print(exporting::kinematics_document(*tree));
  EXPECT_NE(printed.find("L_cylinder { from = fr_L_foot to = L_head }"), std::string::npos) << printed;
  EXPECT_EQ(tree_of(printed).actuators.size(), 2U);
}

// A leg with a loop is attached twice; its frames, its loop and the joint that leads have the instance's prefix.
TEST(Loops, OfPartsAreThoseOfEachInstance) {
  const std::string text =
      "Part Leg(crank[0.2]) { root first via a root other via c "
      "link first { children { rod via b } } "
      "link rod { children {} frames { end { translation = (0.55, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } "
      "link other { children {} frames { pin { translation = (0.4, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } "
      "r_joint a { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (PI/2.0, 0.0, 1.2) } } "
      "r_joint b { ref_frame { translation = (crank, 0.0, 0.0) rotation = (0.0, 0.0, -0.8) } } "
      "r_joint c { ref_frame { translation = (0.5, 0.0, 0.0) rotation = (PI/2.0, 0.0, 1.4) } } "
      "loops { bar { frames = end ~ pin type = hinge } } independent { b } } "
      "Robot Two { RobotBase trunk { children { Leg L at { translation = (0.0, 0.2, 0.0) rotation = (0.0, 0.0, 0.0) } "
      "Leg R(crank = 0.25) at { translation = (0.0, -0.2, 0.0) rotation = (0.0, 0.0, 0.0) } mirrored y } } }";
  Diagnostics diagnostics;
  const auto read = import::robot_document(std::make_shared<const Source>("two.kindsl", text), {}, diagnostics);
  ASSERT_TRUE(read) << diagnostics.render();
  const auto tree = import::kinematic_tree(read->document, diagnostics);
  ASSERT_TRUE(tree) << diagnostics.render();
  EXPECT_EQ(coordinates(*tree), (Names{"L_b", "R_b"}));
  ASSERT_EQ(tree->loops.size(), 2U);
  EXPECT_EQ(tree->loops[0].name, "L_bar");
  EXPECT_EQ(tree->loops[1].ends[0].frame, "R_end");
  EXPECT_EQ(tree->closures.size(), 2U);
}

}  // namespace
}  // namespace robcogen::test::loops_test
