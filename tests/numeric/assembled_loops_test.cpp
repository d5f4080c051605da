// Loops that are flat when all joints are at zero, and whose joints declare the position in which they are assembled.
// They are compared with the reference, and with the same robot drawn in the assembled position.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "document_tree.h"
#include "export/kinematics.h"
#include "import/kinematics.h"
#include "import/parts.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "model/closed_positions.h"
#include "robcogen/reference/samples.h"

namespace robcogen::numeric::assembled_loops_test {
namespace {

using model::KinematicTree;
using reference::Vector;

// An arm in the x-y plane: the position of each joint along its parent link, and the angle at which it is assembled.
struct Arm {
  struct Joint {
    std::string name;
    double along, assembled;
  };
  double base;  // x of the first joint
  std::vector<Joint> joints;
  double end;  // x of the frame on the last link
};

struct Mechanism {
  std::string name;
  Arm left, right;
  std::string type, independent;
  model::Closure::Method method;
};

void PrintTo(const Mechanism& mechanism, std::ostream* out) {
  *out << mechanism.name;
}

// All joints lie on one line at zero. The mechanisms are a six-bar whose loop has two followers; a crank, a rod and a
// rocker; and the same with the rod in two pieces that are welded together, so that three joints follow.
const std::vector<Mechanism> kMechanisms = {
    {"SixBar",
     {0.0, {{"a", 0.0, 0.0}, {"b", 0.1, 0.0}, {"c", 0.2, 0.0}}, 0.3},
     {0.0, {{"d", 0.0, 0.0}, {"e", 0.4, 2.2}}, 0.5},
     "hinge",
     "a, b, c",
     model::Closure::Method::planar},
    {"FourBar",
     {0.0, {{"a", 0.0, 1.1}, {"b", 0.2, -0.6}}, 0.7},
     {0.5, {{"c", 0.0, 1.3}}, 0.4},
     "hinge",
     "a",
     model::Closure::Method::planar},
    {"WeldedRod",
     {0.0, {{"a", 0.0, 1.1}, {"b", 0.2, -0.6}}, 0.35},
     {0.5, {{"c", 0.0, 1.3}, {"d", 0.4, -0.7}}, -0.35},
     "weld",
     "a",
     model::Closure::Method::iterative}};

// Writes the document of a mechanism. With `is_drawn` the placements of the joints are turned to their assembled
// positions.
class Writer {
 public:
  Writer(const Mechanism& mechanism, bool says_assembled, bool is_drawn)
      : mechanism_(mechanism), says_assembled_(says_assembled), is_drawn_(is_drawn) {}

  std::string text() {
    std::string roots;
    for (const Arm* arm : {&mechanism_.left, &mechanism_.right}) roots += add(*arm, arm == &mechanism_.left);
    return "Robot Flat { RobotBase base { children { " + roots + "} } " + links_ + joints_ +
           "loops { bar { frames = left_end ~ right_end type = " + mechanism_.type + " } } independent { " +
           mechanism_.independent + " } }";
  }

 private:
  const Mechanism& mechanism_;
  bool says_assembled_, is_drawn_;
  std::string links_, joints_;
  int id_ = 0;

  std::string add(const Arm& arm, bool is_left) {
    for (std::size_t k = 0; k < arm.joints.size(); ++k) {
      const Arm::Joint& joint = arm.joints[k];
      const bool is_last = k + 1 == arm.joints.size();
      const std::string next = is_last ? "" : fmt::format("l{0} via {0}", arm.joints[k + 1].name);
      links_ += fmt::format(
          "link l{} {{ id = {} inertia_params {{ mass = 1.3 CoM = (0.12, 0.03, 0.02) Ix = 0.06 Iy = 0.065 Iz = 0.07 "
          "Ixy = 0.001 Ixz = -0.002 Iyz = 0.0015 }} children {{ {} }} {} }} ",
          joint.name, ++id_, next,
          is_last ? fmt::format(
                        "frames {{ {}_end {{ translation = ({:.2f}, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) }} }}",
                        is_left ? "left" : "right", arm.end)
                  : "");
      joints_ += fmt::format(
          "r_joint {} {{ ref_frame {{ translation = ({:.2f}, 0.0, 0.0) rotation = (0.0, 0.0, {:.2f}) }} {} }} ",
          joint.name, k == 0 ? arm.base : joint.along, is_drawn_ ? joint.assembled : 0.0,
          says_assembled_ && joint.assembled != 0.0 ? fmt::format("assembled = {:.2f}", joint.assembled) : "");
    }
    return fmt::format("l{0} via {0} ", arm.joints.front().name);
  }
};

std::string flat(const Mechanism& m) {
  return Writer(m, false, false).text();
}
std::string assembled(const Mechanism& m) {
  return Writer(m, true, false).text();
}
std::string drawn(const Mechanism& m) {
  return Writer(m, false, true).text();
}

class AssembledLoops : public testing::TestWithParam<Mechanism> {};

TEST_P(AssembledLoops, AreRefusedWithoutAPosition) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("flat.kindsl", flat(GetParam()));
  EXPECT_FALSE(import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics));
  // The message says where a loop that is drawn stretched could close, or only that joints can be given a position.
  const std::string message = diagnostics.render();
  EXPECT_TRUE(
      message.find("hint: write 'assembled = ") != std::string::npos ||
      message.find("or give joints a position") != std::string::npos)
      << message;
}

TEST_P(AssembledLoops, AgreeWithTheReference) {
  const KinematicTree tree = tree_of_text(assembled(GetParam()));
  ASSERT_EQ(tree.closures.size(), 1U);
  EXPECT_EQ(tree.closures.front().method, GetParam().method);
  EXPECT_EQ(check_all(InterpretedRobot(tree, model::all_desired(tree)), 7, 4).failure_report(), "");
}

// Positions of the two robots differ by the assembled positions of the joints.
TEST_P(AssembledLoops, MoveAsIfDrawnThere) {
  const KinematicTree tree = tree_of_text(assembled(GetParam())), other = tree_of_text(drawn(GetParam()));
  const InterpretedRobot robot(tree, {}), same(other, {});
  const std::vector<int> coordinates = tree.coordinates();
  ASSERT_EQ(coordinates, other.coordinates());
  std::mt19937_64 engine(5);
  for (int i = 0; i < 5; ++i) {
    symbolic::Arrays<double> inputs;
    for (const char* name : {"qd", "qdd", "tau"})
      inputs[name] = reference::uniform_vector(engine, tree.dof(), 2.0).values();
    symbolic::Arrays<double> there = inputs;
    for (const int j : coordinates) {
      const double way = reference::uniform(engine, 0.1);
      inputs["q"].push_back(way + tree.joints[static_cast<std::size_t>(j)].assembled.value_or(0.0));
      there["q"].push_back(way);
    }
    for (const auto& [closed, q] : {std::pair(&tree, &inputs.at("q")), {&other, &there.at("q")}})
      for (const double follower : model::closed_followers(*closed, *q, {})) q->push_back(follower);
    for (const auto& [function, result] :
         {std::pair("inverse_dynamics", "tau"), {"forward_dynamics", "qdd"}, {"joint_space_inertia", "H"}}) {
      const std::vector<double> wanted = same.run(function, {}, there).at(result);
      const std::vector<double> found = robot.run(function, {}, inputs).at(result);
      for (std::size_t k = 0; k < wanted.size(); ++k)
        EXPECT_NEAR(found[k], wanted[k], 1e-9 * (1 + std::abs(wanted[k]))) << function << " " << k;
    }
  }
}

TEST_P(AssembledLoops, PrintAsTheyWereRead) {
  const KinematicTree tree = tree_of_text(assembled(GetParam()));
  const KinematicTree again = tree_of_text(language::kinematics::print(exporting::kinematics_document(tree)));
  for (std::size_t j = 0; j < tree.joints.size(); ++j) EXPECT_EQ(again.joints[j].assembled, tree.joints[j].assembled);
  EXPECT_EQ(again.coordinates(), tree.coordinates());
}

INSTANTIATE_TEST_SUITE_P(
    ,
    AssembledLoops,
    testing::ValuesIn(kMechanisms),
    [](const testing::TestParamInfo<Mechanism>& of) { return of.param.name; });

// A parallelogram with sides of 0.2 m and 0.5 m, flat at zero, where the crossed and the parallel branch meet.
TEST(AssembledParallelograms, AreCrossedWhereTheirJointsSaySo) {
  const auto tree = [](double b, double c) {
    Mechanism m = {"", {0.0, {{"a", 0.0, 0.5}, {"b", 0.2, b}}, 0.5}, {0.5, {{"c", 0.0, c}}, 0.2}, "hinge", "a", {}};
    return tree_of_text(assembled(m));
  };
  const KinematicTree parallel = tree(-0.5, 0.5), crossed = tree(-1.2, -1.3);
  EXPECT_TRUE(parallel.closures.empty());
  EXPECT_EQ(parallel.parallelograms.size(), 1U);
  ASSERT_EQ(crossed.closures.size(), 1U);
  EXPECT_EQ(check_all(InterpretedRobot(crossed, model::all_desired(crossed)), 7, 4).failure_report(), "");
}

// In a mirrored part, the image of a joint that keeps its sense is assembled at the opposite position.
TEST(AssembledParts, AreMirrored) {
  const Mechanism& m = kMechanisms[1];
  std::string text = assembled(m);
  text.replace(0, text.find("link la"), "Part Leg { root la via a root lc via c ");
  text +=
      " Robot Two { RobotBase trunk { children { Leg L at { translation = (0.0, 0.2, 0.0) rotation = (0.0, 0.0, 0.0) } "
      "Leg R at { translation = (0.0, -0.2, 0.0) rotation = (0.0, 0.0, 0.0) } mirrored y same sense } } }";
  Diagnostics diagnostics;
  const auto read = import::robot_document(std::make_shared<const Source>("two.kindsl", text), {}, diagnostics);
  ASSERT_TRUE(read) << diagnostics.render();
  const auto tree = import::kinematic_tree(read->document, diagnostics);
  ASSERT_TRUE(tree) << diagnostics.render();
  ASSERT_EQ(tree->closures.size(), 2U);
  const auto of = [&](const char* joint) {
    return *tree->joints[static_cast<std::size_t>(*tree->find_joint(joint))].assembled;
  };
  EXPECT_EQ(of("L_a"), 1.1);
  EXPECT_EQ(of("R_a"), -1.1);
  EXPECT_EQ(check_all(InterpretedRobot(*tree, model::all_desired(*tree)), 7, 4).failure_report(), "");
}

}  // namespace
}  // namespace robcogen::numeric::assembled_loops_test
