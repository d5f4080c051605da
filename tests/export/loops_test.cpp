// Loops of trees: which joints follow, how loops are assembled, and what is printed of them.
#include <gtest/gtest.h>

#include "export/kinematics.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "language/kinematics/document.h"

namespace robcogen::test {
namespace {

// A crank, a rod and a rocker; `more` stands in the robot.
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

// Drawn with the elbow up or down: the same sides, mirrored.
TEST(Loops, AreAssembledAsTheyAreDrawn) {
  const model::KinematicTree up = tree_of(four_bar("")), down = tree_of(four_bar("", "-2.2", "-1.9"));
  ASSERT_EQ(up.closures.size(), 1U);
  ASSERT_EQ(down.closures.size(), 1U);
  EXPECT_EQ(up.closures[0].branch, -down.closures[0].branch);
  // Where the joints that follow are at zero: not where they are drawn, since that does not close.
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

// A leg with a loop, attached twice: its frames, its loop and what leads it have the prefix of the instance.
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
}  // namespace robcogen::test
