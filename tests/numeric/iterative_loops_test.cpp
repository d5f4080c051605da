// Robots with loops that no formulas close: in space, with frames that slide or are welded, and loops that close
// together.
#include <gtest/gtest.h>

#include "import/kinematics.h"
#include "interpreted_robot.h"
#include "language/kinematics/document.h"
#include "random_robot.h"
#include "reference_tables.h"
#include "robcogen/reference/loops.h"

namespace robcogen::numeric {
namespace {

using reference::Real;
using reference::Vector;
using Names = std::vector<std::string>;

std::string inertia(double mass, double x, double y, double z) {
  const auto text = [](double v) { return std::to_string(v); };
  return " inertia_params { mass = " + text(mass) + " CoM = (" + text(x) + ", " + text(y) + ", " + text(z) +
         ") Ix = 0.06 Iy = 0.065 Iz = 0.07 Ixy = 0.001 Ixz = -0.002 Iyz = 0.0015 } ";
}

std::string at(const std::string& translation, const std::string& rotation = "0.0, 0.0, 0.0") {
  return " { translation = (" + translation + ") rotation = (" + rotation + ") } ";
}

// A four-bar in the plane of x and y, cut in the middle of its rod.
std::string cut_rod(const std::string& leaders, const std::string& turned = "0.0, -PI/2.0, PI") {
  return "Robot Bar { RobotBase base { children { crank via a rocker via c } } link crank { id = 1 " +
         inertia(1, 0.1, 0.02, 0.1) + "children { first via b } } link first { id = 2 " + inertia(0.5, 0.1, 0, 0) +
         "children {} frames { end" + at("0.3, 0.0, 0.0", "0.0, PI/2.0, 0.0") + "} } link rocker { id = 3 " +
         inertia(0.7, 0.2, 0.01, 0) + "children { second via d } } link second { id = 4 " + inertia(0.4, 0.1, 0, 0.05) +
         "children {} frames { pin" + at("0.25, 0.0, 0.0", turned) + "} } r_joint a { ref_frame" +
         at("0.0, 0.0, 0.0", "0.0, 0.0, 1.2") + "} r_joint b { ref_frame" + at("0.2, 0.0, 0.0", "0.0, 0.0, -0.8") +
         "} r_joint c { ref_frame" + at("0.5, 0.0, 0.0", "0.0, 0.0, 1.4") + "} r_joint d { ref_frame" +
         at("0.4, 0.0, 0.0", "0.0, 0.0, 2.0") + "damping = 0.3 } loops { cut { frames = end ~ pin type = weld } } " +
         leaders + "}";
}

// A crank and a rocker about axes that are not parallel, and a rod on a universal joint that ends in a ball.
std::string spatial_four_bar(const std::string& leaders) {
  return "Robot Spatial { RobotBase base { children { crank via a rocker via c } } link crank { id = 1 " +
         inertia(1, 0.1, 0.02, 0.1) + "children { rod via u } } link rod { id = 2 " + inertia(0.5, 0.2, 0.01, 0) +
         "children {} frames { end" + at("0.0, 0.6, 0.0") + "} } link rocker { id = 3 " + inertia(0.7, 0.2, 0.01, 0) +
         "children {} frames { pin" + at("0.3, 0.0, 0.1") + "} } r_joint a { ref_frame" +
         at("0.0, 0.0, 0.0", "0.1, 0.2, 0.3") + "armature = 0.1 } u_joint u { ref_frame" +
         at("0.2, 0.0, 0.05", "0.0, 0.2, -0.6 - PI/2.0") + "} r_joint c { ref_frame" +
         at("0.7, 0.1, 0.0", "-1.2, 0.3, 1.746") + "} loops { ball { frames = end ~ pin type = point } } " + leaders +
         "}";
}

// Three arms carry a platform by rods of a fixed length. The platform slides along three axes, or turns, too.
std::string delta(const std::string& leaders) {
  std::string arms, frames, joints, loops, children;
  for (int k = 0; k < 3; ++k) {
    const std::string n = std::to_string(k), turn = std::to_string(k) + ".0 * 2.0 PI/3.0";
    const double angle = 2 * 3.14159265358979323846 * k / 3;
    const auto around = [&](double r) {
      return std::to_string(r * std::cos(angle)) + ", " + std::to_string(r * std::sin(angle)) + ", 0.0";
    };
    children += " hub" + n + " via turn" + n;
    arms += "link hub" + n + " { id = " + std::to_string(4 + k) + inertia(0.4, 0.1, 0, 0) + "children {} frames { tip" +
            n + at("0.25, 0.0, 0.0") + "} } ";
    frames += "pin" + n + at(around(0.05));
    joints +=
        "r_joint turn" + n + " { ref_frame" + at(around(0.12), "-PI/2.0, " + turn + ", 0.3") + "armature = 0.01 } ";
    loops += "rod" + n + " { frames = tip" + n + " ~ pin" + n + " distance = 0.6 } ";
  }
  return "Robot Delta { RobotBase base { children { sx via x" + children +
         " } } link sx { id = 1 children { sy via y } } link sy { id = 2 children { sz via z } } link sz { id = 3 " +
         inertia(0.5, 0, 0, -0.02) + "children {} frames { " + frames + "} } " + arms + "p_joint x { ref_frame" +
         at("0.0, 0.0, -0.55", "0.0, PI/2.0, 0.0") + "} p_joint y { ref_frame" +
         at("0.0, 0.0, 0.0", "-PI/2.0, 0.0, 0.0") + "} p_joint z { ref_frame" +
         at("0.0, 0.0, 0.0", "0.0, -PI/2.0, -PI/2.0") + "} " + joints + "loops { " + loops + "} " + leaders + "}";
}

// A slide across a crank: the frame of the crank's pin slides along the other link, and both turn together.
std::string slotted(const std::string& leaders) {
  return "Robot Slot { RobotBase base floating { " + inertia(3, 0, 0.1, 0) +
         "children { crank via a lever via c } } link crank { id = 1 " + inertia(1, 0.1, 0.02, 0.1) +
         "children { block via b } } link block { id = 2 " + inertia(0.5, 0.01, 0, 0) + "children {} frames { end" +
         at("0.0, 0.0, 0.0", "0.0, PI/2.0, 0.0") + "} } link lever { id = 3 " + inertia(0.7, 0.2, 0.01, 0) +
         "children {} frames { slot" + at("0.1, 0.0, 0.0", "0.0, PI/2.0, 0.0") + "} } r_joint a { ref_frame" +
         at("0.0, 0.0, 0.0", "0.0, 0.0, 1.2") + "} r_joint b { ref_frame" + at("0.2, 0.0, 0.0", "0.0, 0.0, -1.0") +
         "} r_joint c { ref_frame" + at("-0.4, 0.1, 0.0", "0.0, 0.0, 0.2") +
         "} loops { slide { frames = slot ~ end type = slider } } " + leaders + "}";
}

struct Case {
  std::string name, document;
  Names coordinates, followers;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"WeldedRod", cut_rod("independent { a }"), {"a"}, {"b", "c", "d"}},
      {"SpatialFromTheCrank", spatial_four_bar(""), {"a"}, {"u_turn_x", "u_turn_z", "c"}},
      {"SpatialFromTheRocker", spatial_four_bar("independent { c }"), {"c"}, {"a", "u_turn_x", "u_turn_z"}},
      {"DeltaByItsMotors", delta(""), {"turn0", "turn1", "turn2"}, {"x", "y", "z"}},
      {"DeltaMixed", delta("independent { turn0, turn1, z }"), {"z", "turn0", "turn1"}, {"x", "y", "turn2"}},
      {"Slot", slotted("independent { a }"), {"a"}, {"b", "c"}}};
  return all;
}

model::KinematicTree tree_of(const Case& c) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("iterative.kindsl", c.document);
  auto tree = import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics);
  EXPECT_TRUE(tree) << diagnostics.render();
  return tree ? *tree : model::KinematicTree();
}

Names names_of(const model::KinematicTree& tree, const std::vector<int>& joints) {
  Names names;
  for (const int joint : joints) names.push_back(tree.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

class IterativeLoops : public testing::TestWithParam<Case> {};

TEST_P(IterativeLoops, HaveTheseCoordinates) {
  const model::KinematicTree tree = tree_of(GetParam());
  ASSERT_EQ(tree.closures.size(), 1U);
  EXPECT_EQ(tree.closures.front().method, model::Closure::Method::iterative);
  EXPECT_EQ(names_of(tree, tree.coordinates()), GetParam().coordinates);
  EXPECT_EQ(names_of(tree, tree.followers_in_q()), GetParam().followers);
}

TEST_P(IterativeLoops, AgreeWithTheReference) {
  const model::KinematicTree tree = tree_of(GetParam());
  for (const bool is_optimised : {false, true}) {
    const InterpretedRobot robot(
        tree, random_desired(7, tree), is_optimised ? all_steps() : std::vector<std::string>{});
    EXPECT_EQ(check_all(robot, 3, 4).failure_report(), "");
  }
}

// From where the joints that follow were a little before.
TEST_P(IterativeLoops, CloseInAFewSteps) {
  const model::KinematicTree tree = tree_of(GetParam());
  const InterpretedRobot robot(tree, {}, all_steps(), {}, {}, {"transforms"});
  const reflection::Robot tables = robot.tables();
  std::mt19937_64 engine(11);
  for (int i = 0; i < 10; ++i) {
    reference::Sample sample;
    const reference::AtLoops closed = draw(engine, tables, sample);
    const std::vector<double> wanted = sample.motion.q.values();
    std::vector<double> guess = wanted;
    for (std::size_t k = static_cast<std::size_t>(tables.dof()); k < guess.size(); ++k)
      guess[k] += reference::uniform(engine, 0.05);
    const std::vector<double> found = robot.run("close_loops", {}, {{"q", guess}}).at("q");
    for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], 1e-10) << k;
    const std::vector<double> all = robot.run("joint_positions", {}, {{"q", found}}).at("positions");
    const std::vector<double> open = robot.run("loop_error", {}, {{"positions", all}}).at("error");
    for (const double e : open) EXPECT_NEAR(e, 0.0, 1e-10);
  }
}

// Where no position of the joints that follow closes the loops, they are not numbers.
TEST(IterativeLoops, SayThatTheyDoNotClose) {
  const model::KinematicTree tree = tree_of(cases()[3]);
  const InterpretedRobot robot(tree, {}, {}, {}, {}, {"transforms"});
  std::vector<double> q(6);
  q[0] = 2.5, q[1] = -2.5, q[2] = 0.4;
  for (std::size_t k = 3; k < 6; ++k) q[k] = 0.1;
  const std::vector<double> found = robot.run("close_loops", {}, {{"q", q}}).at("q");
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[k], q[k]);
  for (std::size_t k = 3; k < 6; ++k) EXPECT_TRUE(std::isnan(found[k])) << found[k];
}

// Axes that are off by rounding: the same joints follow, and go where they went.
TEST(IterativeLoops, DoNotMindRoundingNoise) {
  const std::string text = cut_rod("independent { a }");
  std::string noisy = text;
  for (const auto& [from, to] :
       {std::pair("0.0, 0.0, -0.8", "3e-11, -3e-18, -0.8"), {"0.0, 0.0, 1.4", "0.0, 4e-12, 1.4"}})
    noisy.replace(noisy.find(from), std::string(from).size(), to);
  const model::KinematicTree exact = tree_of({"Exact", text, {}, {}}), noise = tree_of({"Noisy", noisy, {}, {}});
  EXPECT_EQ(names_of(noise, noise.followers_in_q()), names_of(exact, exact.followers_in_q()));
  const auto closed = [](const model::KinematicTree& tree) {
    const InterpretedRobot robot(tree, {}, all_steps(), {}, {}, {"transforms"});
    std::vector<double> q = {0.02};
    for (const int follower : tree.followers_in_q()) q.push_back(model::evaluate(tree.coupling_of(follower)->offset));
    return robot.run("close_loops", {}, {{"q", q}}).at("q");
  };
  const std::vector<double> wanted = closed(exact), found = closed(noise);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], 1e-9) << k;
}

// Half a turn has no sine, as no turn.
TEST(IterativeLoops, AreNotClosedTheOtherWayRound) {
  Diagnostics diagnostics;
  const std::string text = cut_rod("independent { a }", "PI, PI/2.0, 0.0");
  const auto source = std::make_shared<const Source>("turned.kindsl", text);
  EXPECT_FALSE(import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics));
  EXPECT_NE(diagnostics.render().find("loop-cannot-close"), std::string::npos) << diagnostics.render();
}

INSTANTIATE_TEST_SUITE_P(
    Mechanism,
    IterativeLoops,
    testing::ValuesIn(cases()),
    [](const testing::TestParamInfo<Case>& of) { return of.param.name; });

}  // namespace
}  // namespace robcogen::numeric
