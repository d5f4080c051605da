// Conversion of robots with loops to URDF+ and back.
#include <gtest/gtest.h>

#include "coupling_sums.h"
#include "document_tree.h"
#include "export/urdf.h"
#include "export/urdf_loops.h"
#include "import/urdf.h"
#include "interpreted_robot.h"
#include "robcogen/reference/loops.h"
#include "robots.h"

namespace robcogen::test::urdf_loops_test {
namespace {

using model::KinematicTree;
using numeric::InterpretedRobot;

constexpr double kSame = 1e-10;

KinematicTree through_urdf(const KinematicTree& tree) {
  Diagnostics diagnostics;
  import::UrdfOptions options;
  options.passive_forces = true;
  auto back = import::urdf(std::make_shared<Source>("exported.urdf", exporting::urdf(tree)), options, diagnostics);
  EXPECT_TRUE(back) << diagnostics.render() << exporting::urdf(tree);
  if (!back) throw std::runtime_error("the URDF is refused");
  return *std::move(back);
}

std::vector<std::string> names_of(const KinematicTree& tree, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int j : joints) names.push_back(tree.joints[static_cast<std::size_t>(j)].name);
  return names;
}

void expect_same_motion(const KinematicTree& found, const KinematicTree& expected) {
  ASSERT_EQ(names_of(found, found.coordinates()), names_of(expected, expected.coordinates()));
  const InterpretedRobot back(found, {}, {}, {}, {}, {"forward_dynamics"});
  const InterpretedRobot robot(expected, {}, {}, {}, {}, {"forward_dynamics"});
  std::mt19937_64 engine(3);
  for (int i = 0; i < 5; ++i) {
    reference::Sample sample;
    draw(engine, robot.tables(), sample);
    const reference::Vector<double> tau = reference::uniform_vector(engine, expected.dof(), 5.0);
    const auto wanted = robot.forward_dynamics(sample.motion, tau, {&sample.gravity, nullptr});
    const auto accelerations = back.forward_dynamics(sample.motion, tau, {&sample.gravity, nullptr});
    for (int k = 0; k < wanted.rows(); ++k)
      EXPECT_NEAR(accelerations(k), wanted(k), kSame * (1 + std::abs(wanted(k)))) << k;
  }
}

// A robot of the folder robots, with only the drive properties that URDF has.
class UrdfLoops : public testing::TestWithParam<std::string> {
 protected:
  static KinematicTree robot() {
    Diagnostics diagnostics;
    const auto file = std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / GetParam() / (GetParam() + ".kindsl");
    auto tree = read_document(source_of(file), diagnostics);
    if (!tree) throw std::runtime_error(diagnostics.render());
    for (model::Joint& joint : tree->joints) {
      const model::Drive drive = std::exchange(joint.drive, {});
      joint.drive.damping = drive.damping;
      joint.drive.friction = drive.friction;
    }
    return *std::move(tree);
  }
};

TEST_P(UrdfLoops, AreReadBack) {
  const KinematicTree tree = robot();
  ASSERT_FALSE(tree.loops.empty());
  const KinematicTree once = through_urdf(tree), twice = through_urdf(once);
  for (const KinematicTree* back : {&once, &twice}) {
    EXPECT_EQ(back->loops.size(), tree.loops.size());
    EXPECT_EQ(back->closures.size(), tree.closures.size());
    EXPECT_EQ(back->parallelograms.size(), tree.parallelograms.size());
    expect_same_motion(*back, tree);
  }
  EXPECT_EQ(twice.user_frames.size(), once.user_frames.size());
}

INSTANTIATE_TEST_SUITE_P(, UrdfLoops, testing::Values("five_bar", "four_bar_leg", "palletiser"));

// Bars that are drawn on one line: joints keep the positions in which the loop is assembled.
TEST(UrdfLoopsOnOneLine, KeepTheirAssembly) {
  const std::string inertia =
      "inertia_params { mass = 1.0 CoM = (0.1, 0.0, 0.0) Ix = 0.02 Iy = 0.03 Iz = 0.03 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 "
      "} ";
  const auto joint = [](const std::string& name, const std::string& x, const std::string& assembled) {
    return "r_joint " + name + " { ref_frame { translation = (" + x + ", 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } " +
           assembled + " } ";
  };
  for (const double side : {1.0, -1.0}) {
    const std::string position = "assembled = " + std::to_string(2.4 * side);
    const KinematicTree tree = numeric::tree_of_text(
        "Robot FourBar { RobotBase base { children { crank via a rocker via c } } link crank { id = 1 " + inertia +
        "children { rod via b } } link rod { id = 2 " + inertia +
        "children {} frames { end { translation = (0.4, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } link rocker { id = "
        "3 " +
        inertia + "children {} frames { pin { translation = (0.5, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } } " +
        joint("a", "0.0", "") + joint("b", "0.2", "") + joint("c", "0.8", position) +
        "loops { bar { frames = end ~ pin type = hinge } } independent { a } }");
    ASSERT_TRUE(exporting::may_be_urdf_loop(tree.loops.front()));
    const KinematicTree back = through_urdf(tree);
    // With the crank on the line, the sides are 0.6, 0.4 and 0.5: the angle at b by the law of cosines.
    const double expected = side * std::acos((0.36 + 0.16 - 0.25) / (2 * 0.6 * 0.4));
    for (const KinematicTree* one : {&tree, &back}) {
      const model::Coupling* coupling = one->coupling_of(*one->find_joint("b"));
      ASSERT_NE(coupling, nullptr);
      EXPECT_NEAR(model::evaluate(coupling->offset), expected, 1e-9);
    }
    expect_same_motion(back, tree);
  }
}

// A belt along the upper arm: the second rotor turns by the sum of both joints.
TEST(UrdfCouplings, AreSumsAlongPaths) {
  const std::string at = " { ref_frame { translation = (0.0, 0.0, 0.1) rotation = (0.0, 0.0, 0.0) } } ";
  const auto link = [](const std::string& name, int id, const std::string& children) {
    return "link " + name + " { id = " + std::to_string(id) +
           " inertia_params { mass = 1.0 CoM = (0.1, 0.0, 0.0) Ix = 0.02 Iy = 0.03 Iz = 0.03 Ixy = 0.0 Ixz = 0.0 Iyz = "
           "0.0 } children { " +
           children + " } } ";
  };
  const auto robot = [&](const std::string& coupling) {
    return numeric::tree_of_text(
        "Robot Belt { RobotBase base { children { upper via a first via m second via n } } " +
        link("upper", 1, "lower via b") + link("lower", 2, "") + link("first", 3, "") + link("second", 4, "") +
        "r_joint a" + at + "r_joint b" + at + "r_joint m" + at + "r_joint n" + at + "couplings { " + coupling + " } }");
  };
  for (const char* coupling : {"m = 6.0 * a + 6.0 * b n = 2.0 * a", "b = 0.5 * m - 1.0 * a"}) {
    const KinematicTree tree = robot(coupling);
    EXPECT_EQ(sums(through_urdf(tree)), sums(tree));
    expect_same_motion(through_urdf(tree), tree);
  }
  // URDF+ cannot express these: no path contains both motors on the base.
  for (const char* coupling : {"b = 0.5 * m + 0.5 * n", "m = 6.0 * a + 6.0 * b + 0.1", "m = 6.0 * a + 5.0 * b"}) {
    const KinematicTree tree = robot(coupling);
    EXPECT_FALSE(exporting::has_urdf_form(tree, tree.couplings.front())) << coupling;
  }
}

}  // namespace
}  // namespace robcogen::test::urdf_loops_test
