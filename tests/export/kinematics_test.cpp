// A model that is written as a robot document and read back is the same model.
#include "export/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_drives.h"
#include "random_robot.h"
#include "robots.h"
#include "same_tree.h"

namespace robcogen::kinematics_test {
namespace {

using model::KinematicTree;
using model::Quantity;
using test::SameTree;

std::optional<KinematicTree> written_and_read(const KinematicTree& tree) {
  const auto document = exporting::kinematics_document(tree);
  const std::string text = language::kinematics::print(document);
  Diagnostics diagnostics;
  const auto source = std::make_shared<Source>("test.kindsl", text);
  const auto parsed = language::kinematics::parse(source, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render() << text;
  EXPECT_TRUE(language::kinematics::equal(parsed, document)) << text;
  const auto result = import::kinematic_tree(parsed, diagnostics);
  EXPECT_TRUE(result.has_value()) << diagnostics.render() << text;
  return result;
}

TEST(ExportedDocument, IsTheSameModel) {
  for (const test::NamedRobot& robot : test::all_robots()) {
    SCOPED_TRACE(robot.document);
    if (const auto found = written_and_read(robot.tree)) SameTree(*found, robot.tree).expect();
  }
}

// Random robots give their mass properties in frames that are not link frames; the export moves these properties.
TEST(ExportedDocument, OfARandomRobotIsTheSameModel) {
  constexpr std::uint64_t kRobots = 300;
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const KinematicTree robot = numeric::random_robot(seed, {1, 40, numeric::Shape::any, false});
    SCOPED_TRACE(numeric::describe(robot));
    if (const auto found = written_and_read(robot)) SameTree(*found, robot).expect();
    if (HasFailure()) return;
  }
}

TEST(ExportedDocument, KeepsDrivesAndLimits) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    KinematicTree robot =
        numeric::with_random_drives(numeric::random_robot(seed, {1, 20, numeric::Shape::any, false}), seed);
    robot.joints[0].limits = {-0.5, 1.25, 3.5, 40};
    robot.joints.back().limits.effort = 12;
    SCOPED_TRACE(numeric::describe(robot));
    if (const auto found = written_and_read(robot)) SameTree(*found, robot).expect();
    if (HasFailure()) return;
  }
}

KinematicTree read(const std::string& text) {
  Diagnostics diagnostics;
  const auto tree = test::read_document(std::make_shared<Source>("test.kindsl", text), diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  return tree.value_or(KinematicTree{});
}

const std::string kInFrame = R"(Robot r {
  RobotBase base { children { arm via j } }
  link arm {
    id = 1
    inertia_params { mass = 2.0 CoM = (0.1, 0.0, 0.0) Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0
                     ref_frame = body }
    children {}
    frames { tip { translation = (0.0, 0.0, 1.0) rotation = (0.0, 0.0, 0.0) }
             body { translation = (0.0, len, 1.0) rotation = (PI/2.0, 0.0, 0.0) } }
  }
  r_joint j { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
})";

TEST(ExportedDocument, KeepsTheFrameOfMassProperties) {
  const auto document = exporting::kinematics_document(read(kInFrame));
  ASSERT_TRUE(document.links[1].inertia->reference.has_value());
  EXPECT_EQ(document.links[1].inertia->reference->text, "body");
}

// The frame has no name, so the properties are moved. The link is massless, so its centre of mass cannot be found by
// division by the mass.
TEST(ExportedDocument, MovesMassPropertiesFromAFrameThatHasNoName) {
  KinematicTree tree = read(kInFrame);
  tree.user_frames.clear();
  tree.links[1].inertia->mass = Quantity();
  model::Placement reference;
  reference.translation[2] = Quantity(Number::rational(3));
  reference.rotation[0] = Quantity(Number::pi_multiple(1, 2));
  tree.links[1].inertia->reference = reference;
  tree.links[1].inertia->iyy = Quantity(Number::rational(5));
  tree.parameters.clear();
  const auto found = written_and_read(tree);
  ASSERT_TRUE(found.has_value());
  const model::Inertia& inertia = *found->links[1].inertia;
  EXPECT_EQ(evaluate(inertia.com[0]), 0.1);
  EXPECT_EQ(evaluate(inertia.com[2]), 3.0);
  EXPECT_EQ(evaluate(inertia.iyy), 1.0);
  EXPECT_EQ(evaluate(inertia.izz), 5.0);
}

// The order that a URDF may have: the hand is declared before the arm that carries it, and links and joints are in
// different orders.
KinematicTree children_first() {
  const auto link = [](const std::string& name, const std::string& children) {
    return "link " + name +
           " { id = 1 inertia_params { mass = 1.0 CoM = (0.0, 0.0, 0.0) Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Ixz = 0.0 "
           "Iyz = 0.0 } children { " +
           children + " } }\n";
  };
  const auto joint = [](const std::string& name, const std::string& x) {
    return "r_joint " + name + " { ref_frame { translation = (" + x + ", 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }\n";
  };
  return read(
      "Robot R { RobotBase base { children { arm via shoulder tail via root } }\n" + link("tip", "") +
      link("hand", "tip via finger") + link("tail", "") + link("arm", "hand via wrist") + joint("root", "1.0") +
      joint("finger", "2.0") + joint("shoulder", "3.0") + joint("wrist", "4.0") + "}");
}

TEST(ExportedDocument, DeclaresAndNumbersParentsFirst) {
  const KinematicTree tree = children_first();
  const auto document = exporting::numbered_parents_first(tree, exporting::kinematics_document(tree));
  std::vector<std::string> links, joints;
  std::vector<int> ids;
  for (const auto& link : document.links) {
    links.push_back(link.name.text);
    if (link.id) ids.push_back(*link.id);
  }
  for (const auto& joint : document.joints) joints.push_back(joint.name.text);
  // Joints keep their order if parents come first: `root`, on which no other joint depends, stays first.
  EXPECT_EQ(joints, (std::vector<std::string>{"root", "shoulder", "wrist", "finger"}));
  EXPECT_EQ(links, (std::vector<std::string>{"base", "tail", "arm", "hand", "tip"}));
  EXPECT_EQ(ids, (std::vector<int>{1, 2, 3, 4}));

  const KinematicTree found = read(language::kinematics::print(document));
  ASSERT_EQ(found.joints.size(), tree.joints.size());
  for (const model::Joint& joint : found.joints) {
    const model::Joint& same = tree.joints[static_cast<std::size_t>(tree.find_joint(joint.name).value())];
    EXPECT_EQ(
        found.links[static_cast<std::size_t>(joint.parent)].name,
        tree.links[static_cast<std::size_t>(same.parent)].name);
    EXPECT_EQ(
        found.links[static_cast<std::size_t>(joint.child)].name, tree.links[static_cast<std::size_t>(same.child)].name);
    EXPECT_EQ(evaluate(joint.placement.translation[0]), evaluate(same.placement.translation[0]));
  }
}

TEST(ExportedDocument, KeepsAnOrderOfParentsFirst) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const KinematicTree tree = numeric::random_robot(seed, {1, 40, numeric::Shape::any, false});
    const std::vector<int> order = exporting::joints_parents_first(tree);
    std::vector<int> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    bool was_so = true;
    for (int j = 0; j < tree.dof(); ++j) {
      const int parent = tree.parent_joint_of(j);
      if (parent < 0) continue;
      EXPECT_LT(place[static_cast<std::size_t>(parent)], place[static_cast<std::size_t>(j)]);
      was_so = was_so && parent < j;
    }
    EXPECT_EQ(std::is_sorted(order.begin(), order.end()), was_so);
  }
}

TEST(ExportedDocument, EscapesKeywords) {
  const KinematicTree tree = read(R"(Robot ^Robot {
  RobotBase ^link { children { ^mass via ^id } frames { ^via { translation = (^CoM, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } } }
  link ^mass { id = 1 inertia_params { mass = ^mass CoM = (0.0, 0.0, 0.0) Ix = 1.0 Iy = 1.0 Iz = 1.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 }
               children {} }
  r_joint ^id { ref_frame { translation = (0.0, 0.0, 0.0) rotation = (0.0, 0.0, 0.0) } }
})");
  if (const auto found = written_and_read(tree)) SameTree(*found, tree).expect();
}

}  // namespace
}  // namespace robcogen::kinematics_test
