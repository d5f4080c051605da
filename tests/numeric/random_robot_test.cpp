// Random robots: the same for the same seed, consistent, and of every kind; and shrinking them.
#include "random_robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reference_tables.h"
#include "rewritten_robot.h"
#include "robcogen/reference/dynamics.h"

namespace robcogen::numeric::random_robot_test {
namespace {

using model::KinematicTree;

// Returns an empty string if indices agree in both directions and every link is connected to the base; otherwise the
// fault.
std::string unsound(const KinematicTree& robot) {
  if (robot.links.size() != robot.joints.size() + 1) return "not as many joints as links";
  if (robot.links[0].parent_joint != -1) return "the base has a parent";
  for (int j = 0; j < robot.dof(); ++j) {
    const model::Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    if (robot.links[static_cast<std::size_t>(joint.child)].parent_joint != j) return "child of " + joint.name;
    const auto& siblings = robot.links[static_cast<std::size_t>(joint.parent)].child_joints;
    if (std::count(siblings.begin(), siblings.end(), j) != 1) return "parent of " + joint.name;
  }
  std::vector<int> order = robot.topological();
  std::sort(order.begin(), order.end());
  for (int j = 0; j < robot.dof(); ++j) {
    if (order[static_cast<std::size_t>(j)] != j) return "topological order";
  }
  return "";
}

TEST(RandomRobot, IsTheSameForASeed) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) EXPECT_EQ(describe(random_robot(seed)), describe(random_robot(seed)));
  EXPECT_NE(describe(random_robot(1)), describe(random_robot(2)));
}

TEST(RandomRobot, IsSoundAndOfEveryKind) {
  std::set<std::string> kinds;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const KinematicTree robot = random_robot(seed);
    ASSERT_EQ(unsound(robot), "") << describe(robot);
    ASSERT_GE(robot.dof(), 1);
    ASSERT_LE(robot.dof(), 40);
    kinds.insert(robot.floating_base ? "floating" : "fixed");
    kinds.insert(robot.dof() < 3 ? "small" : robot.dof() > 30 ? "large" : "middling");
    bool branched = false;
    for (const model::Link& link : robot.links) {
      branched = branched || link.child_joints.size() > 1;
      if (!link.inertia && link.parent_joint >= 0) kinds.insert("massless link");
      if (link.inertia && link.inertia->reference) kinds.insert("mass in a frame");
    }
    kinds.insert(branched ? "tree" : "chain");
    for (const model::Joint& joint : robot.joints) {
      kinds.insert(std::array{"revolute", "prismatic", "helical"}[static_cast<std::size_t>(joint.type)]);
      for (const model::Quantity& angle : joint.placement.rotation) {
        if (angle.is_zero()) kinds.insert("zero");
        if (!angle.is_zero() && angle.number().is_pi_multiple()) kinds.insert("right angle");
        if (!angle.number().is_pi_multiple()) kinds.insert("angle");
      }
    }
    if (!robot.user_frames.empty()) kinds.insert("user frame");
    const std::vector<int> order = robot.topological();
    if (!std::is_sorted(order.begin(), order.end())) kinds.insert("shuffled");
  }
  for (const char* kind :
       {"floating", "fixed", "small", "middling", "large", "tree", "chain", "massless link", "mass in a frame",
        "revolute", "prismatic", "helical", "zero", "right angle", "angle", "user frame", "shuffled"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;
}

TEST(RandomRobot, HasTheShapeThatIsAskedFor) {
  const KinematicTree chain = random_robot(3, {.min_joints = 9, .max_joints = 9, .shape = Shape::chain});
  const KinematicTree star = random_robot(3, {.min_joints = 9, .max_joints = 9, .shape = Shape::star});
  EXPECT_EQ(chain.dof(), 9);
  for (const model::Link& link : chain.links) EXPECT_LE(link.child_joints.size(), 1u);
  EXPECT_EQ(star.links[0].child_joints.size(), 9u);
}

// The model's own checks find no fault in the mass properties, and no joint without inertia.
TEST(RandomRobot, HasPlausibleMassProperties) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const KinematicTree robot = random_robot(seed);
    const reference::Tables tables = reference_tables(robot);
    for (const reflection::Link& link : tables.robot().links) {
      if (link.mass == 0) continue;
      const reference::Matrix<double> I = reference::central_inertia<double>(link);
      reference::Matrix<double> second = -I;  // integrals of r r' dm about the centre
      for (int k = 0; k < 3; ++k) second(k, k) += (I(0, 0) + I(1, 1) + I(2, 2)) / 2;
      EXPECT_TRUE(reference::positive_definite(second)) << "seed " << seed << " " << link.name;
    }
  }
}

TEST(RandomRobot, ShrinksToWhatFails) {
  const KinematicTree robot = random_robot(5, {.min_joints = 20, .max_joints = 20, .odd_documents = false});
  const auto has_j7 = [](const KinematicTree& r) { return r.find_joint("j7").has_value(); };
  const KinematicTree small = shrink(robot, has_j7);
  EXPECT_TRUE(has_j7(small));
  EXPECT_EQ(unsound(small), "") << describe(small);
  EXPECT_TRUE(small.user_frames.empty());
  // Only the path to j7 is left.
  int leaves = 0;
  for (const model::Link& link : small.links) leaves += link.child_joints.empty() ? 1 : 0;
  EXPECT_EQ(leaves, 1);
}

TEST(RewrittenRobot, PlacementsSurviveTheWayThroughPoses) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const model::Joint& joint : random_robot(seed).joints) {
      const Pose pose = pose_of(joint.placement);
      EXPECT_LT(largest(pose_of(placement_of(pose)) - pose), 1e-15L);
    }
  }
}

TEST(RewrittenRobot, IsSound) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const KinematicTree robot = random_robot(seed);
    EXPECT_EQ(unsound(reframed(robot).robot), "");
    EXPECT_EQ(unsound(mirrored(robot)), "");
    EXPECT_EQ(unsound(with_locked_joint(robot, robot.dof() / 2, 0.3)), "");
  }
}

}  // namespace
}  // namespace robcogen::numeric::random_robot_test
