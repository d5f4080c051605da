// Loops and couplings of URDF+, compared with robot documents and with sums computed by hand.
#include "coupling_sums.h"
#include "document_tree.h"
#include "interpreted_robot.h"
#include "reading.h"

namespace robcogen {
namespace {

using model::KinematicTree;
using numeric::InterpretedRobot;
using reference::Motion;
using reference::Vector;

constexpr double kSame = 1e-12;

std::string link(const std::string& name, double mass) {
  return "<link name=\"" + name + "\"><inertial><origin xyz=\"0.1 0 0\"/><mass value=\"" + std::to_string(mass) +
         "\"/><inertia ixx=\"0.02\" ixy=\"0\" ixz=\"0\" iyy=\"0.02\" iyz=\"0\" izz=\"0.02\"/></inertial></link>\n";
}

std::string joint(
    const std::string& name,
    const std::string& parent,
    const std::string& child,
    const std::string& inner,
    const std::string& attributes = "") {
  return "<joint name=\"" + name + "\" type=\"continuous\" " + attributes + "><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + inner + "</joint>\n";
}

constexpr const char* kFollows = "independent=\"false\"";

// The axes are along z of the base, or along y.
std::string four_bar(bool along_y) {
  const std::string axis = along_y ? "<axis xyz=\"0 1 0\"/>" : "<axis xyz=\"0 0 1\"/>";
  const auto at = [&](const std::string& x, const std::string& angle) {
    const std::string rpy = along_y ? "0 " + angle + " 0" : "0 0 " + angle;
    return "<origin xyz=\"" + x + " 0 0\" rpy=\"" + rpy + "\"/>" + axis;
  };
  return "<robot name=\"four_bar\">" + link("base", 1) + link("crank", 1) + link("rod", 2) + link("tip", 0.3) +
         link("rocker", 1.5) + joint("a", "base", "crank", at("0", "1.2")) +
         joint("b", "crank", "rod", at("0.2", "-0.8"), kFollows) +
         "<joint name=\"weld\" type=\"fixed\"><parent link=\"rod\"/><child link=\"tip\"/><origin xyz=\"0.5 0 0\" "
         "rpy=\"0.3 0.2 0\"/></joint>" +
         joint("c", "base", "rocker", at("0.5", "1.4"), kFollows) +
         "<loop name=\"bar\" type=\"revolute\"><predecessor link=\"rod\"><origin xyz=\"0.55 0 0\"/></predecessor>"
         "<successor link=\"rocker\"><origin xyz=\"0.4 0 0\"/></successor>" +
         axis + "</loop></robot>";
}

std::vector<std::string> coordinates(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const int j : tree.coordinates()) names.push_back(tree.joints[static_cast<std::size_t>(j)].name);
  return names;
}

double acceleration(const KinematicTree& tree, const Vector<double>& gravity) {
  const InterpretedRobot robot(tree, {}, {}, {}, {}, {"forward_dynamics"});
  Motion<double> motion = reference::at_rest(Vector<double>{0.2});
  motion.qd = {0.7};
  return robot.forward_dynamics(motion, {0.5}, {&gravity, nullptr})(0);
}

TEST(UrdfLoops, MoveAsThoseOfADocument) {
  const KinematicTree tree = test::tree_of(four_bar(false));
  EXPECT_EQ(coordinates(tree), std::vector<std::string>{"a"});
  ASSERT_EQ(tree.loops.size(), 1U);
  EXPECT_EQ(tree.loops[0].ends[0].frame, "bar_predecessor");
  EXPECT_EQ(tree.loops[0].type, model::LoopType::hinge);
  // The rod with its tip in the document: one body, and a second one whose axes are turned.
  const auto body = [](const std::string& name, double m, double along, double I) {
    const std::string steiner = std::to_string(I + m * along * along);
    return "link " + name + " { id = 1 inertia_params { mass = " + std::to_string(m) + " CoM = (" +
           std::to_string(along) + ", 0.0, 0.0) Ix = " + std::to_string(I) + " Iy = " + steiner + " Iz = " + steiner +
           " Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } ";
  };
  std::string text =
      "Robot FourBar { RobotBase base { children { crank via a rocker via c } } " + body("crank", 1, 0.1, 0.02) +
      "children { rod via b } } " + body("rod", 2, 0.1, 0.02) +
      "children { tip via w } frames { end { translation = (0.55, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } " +
      body("tip", 0.3, 0.1, 0.02) + "children {} } " + body("rocker", 1.5, 0.1, 0.02) +
      "children {} frames { pin { translation = (0.4, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } "
      "r_joint a { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 1.2) } } "
      "r_joint b { ref_frame { translation = (0.2, 0.0, 0.0) rotation = (0.0, 0.0, -0.8) } } "
      "r_joint w { ref_frame { translation = (0.5, 0.0, 0.0) rotation = (PITCH, ROLL, 0.0) } } "
      "r_joint c { ref_frame { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, 1.4) } } "
      "couplings { w = 0.0 * a } loops { bar { frames = end ~ pin type = hinge } } independent { a } }";
  // R = Ry(0.2) Rx(0.3), expressed as Rx Ry Rz.
  const double r = 0.3, p = 0.2;
  const double y = std::asin(std::sin(p) * std::cos(r)), x = std::atan2(std::sin(r), std::cos(p) * std::cos(r));
  const double z = std::atan2(-std::sin(p) * std::sin(r), std::cos(p));
  const auto exact = [](double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.17g", value);
    return std::string(buffer);
  };
  text.replace(text.find("PITCH, ROLL, 0.0"), 16, exact(x) + ", " + exact(y) + ", " + exact(z));
  const Vector<double> gravity{0.3, -9.7, 0.5};
  const double expected = acceleration(numeric::tree_of_text(text), gravity);
  EXPECT_NEAR(acceleration(tree, gravity), expected, kSame * (1 + std::abs(expected)));
}

// A quarter turn about x maps (x, y, z) to (x, z, -y).
TEST(UrdfLoops, TurnAboutTheirAxis) {
  const double expected = acceleration(test::tree_of(four_bar(false)), {0.3, -9.7, 0.5});
  std::string turned = four_bar(true);
  // In the turned loop the tip is turned about other axes. Its inertia is that of a ball, so only its centre of mass
  // would differ; both tips are therefore made straight.
  std::string plain = four_bar(false);
  for (std::string* text : {&turned, &plain}) text->replace(text->find("rpy=\"0.3 0.2 0\""), 15, "rpy=\"0 0 0\"");
  const double straight = acceleration(test::tree_of(plain), {0.3, -9.7, 0.5});
  EXPECT_NE(straight, expected);
  const KinematicTree tree = test::tree_of(turned);
  EXPECT_NEAR(acceleration(tree, {0.3, 0.5, 9.7}), straight, kSame * (1 + std::abs(straight)));
}

const std::string kAxis = "<axis xyz=\"0 0 1\"/>";

// An arm with two joints, and two rotors on the base.
std::string geared(const std::string& of_arm, const std::string& of_rotors, const std::string& couplings) {
  return "<robot name=\"geared\">" + link("base", 1) + link("upper", 1) + link("lower", 1) + link("first", 1) +
         link("second", 1) + joint("a", "base", "upper", kAxis, of_arm) + joint("b", "upper", "lower", kAxis, of_arm) +
         joint("m", "base", "first", kAxis, of_rotors) + joint("n", "base", "second", kAxis, of_rotors) + couplings +
         "</robot>";
}

std::string coupling(const std::string& predecessor, const std::string& successor, const std::string& ratio) {
  return "<coupling name=\"of_" + successor + "\"><predecessor link=\"" + predecessor + "\"/><successor link=\"" +
         successor + "\"/><ratio value=\"" + ratio + "\"/></coupling>";
}

const std::string kGears = coupling("upper", "second", "0.1") + coupling("lower", "first", "6");

TEST(UrdfCouplings, AreSumsAlongBothPaths) {
  EXPECT_EQ(test::sums(test::tree_of(geared("", kFollows, "" + kGears))), "m = 6.0 a 6.0 b; n = 0.1 a; ");
}

// a = n / 0.1; b = m / 6 - a.
TEST(UrdfCouplings, AreSolvedTogether) {
  EXPECT_EQ(test::sums(test::tree_of(geared(kFollows, "", kGears))), "a = 10.0 n; b = 1.0/6.0 m -10.0 n; ");
}

// Both couplings say how far a and b turn together: directly, or once a and b are known.
TEST(UrdfCouplings, AreRefusedWhereTheyTieJointsThatLead) {
  const std::string third = joint("k", "base", "third", kAxis) + link("third", 1);
  for (const std::string& couplings :
       {coupling("lower", "first", "6") + coupling("second", "lower", "0.5"),
        coupling("lower", "first", "6") + coupling("upper", "second", "0.1") + third + coupling("lower", "third", "2")})
    EXPECT_EQ(test::imported(geared(kFollows, "", couplings)).of_code("coupling-without-follower").size(), 1U)
        << couplings;
}

TEST(UrdfCouplings, ChooseTheLastJointWhereNoneIsSaidToFollow) {
  EXPECT_EQ(test::sums(test::tree_of(geared("", "", kGears))), "m = 6.0 a 6.0 b; n = 0.1 a; ");
  EXPECT_EQ(
      test::sums(test::tree_of(geared("", "independent=\"true\"", coupling("lower", "first", "2")))),
      "b = -1.0 a 0.5 m; ");
}

}  // namespace
}  // namespace robcogen
