// The smallest and the largest robots, and mass properties at their limits.
#include <gtest/gtest.h>

#include "interpreted_robot.h"
#include "random_robot.h"

namespace robcogen::numeric::extremes_test {
namespace {

using model::KinematicTree;
using model::Quantity;

constexpr std::uint64_t kSeed = 7;

void expect_agreement(const KinematicTree& robot, int states = 3) {
  const InterpretedRobot programs(robot, random_desired(kSeed, robot));
  const reference::Checks checks = check_all(programs, kSeed, states);
  EXPECT_GT(checks.size(), 0);
  EXPECT_EQ(checks.failure_report(), "") << describe(robot);
}

KinematicTree with_joints(int count, bool floating, Shape shape = Shape::chain) {
  KinematicTree robot =
      random_robot(kSeed, {.min_joints = count, .max_joints = count, .shape = shape, .odd_documents = false});
  robot.floating_base = floating;
  if (!robot.links[0].inertia) robot.links[0].inertia = robot.links[1].inertia;
  return robot;
}

KinematicTree lone_base(bool floating) {
  KinematicTree robot = with_joints(1, floating);
  return without_leaf(robot, 1);
}

TEST(Extremes, NoJoints) {
  for (const bool floating : {false, true}) {
    const KinematicTree robot = lone_base(floating);
    ASSERT_EQ(robot.dof(), 0);
    expect_agreement(robot);
  }
}

TEST(Extremes, OneJoint) {
  for (const bool floating : {false, true}) expect_agreement(with_joints(1, floating));
}

// The time grows with the square of the number and faster.
constexpr int kMany = ROBCOGEN_TEST_EVERYTHING ? 100 : 40;

TEST(Extremes, LongChain) {
  for (const bool floating : {false, true}) expect_agreement(with_joints(kMany, floating), 1);
}

TEST(Extremes, LargeStar) {
  for (const bool floating : {false, true}) expect_agreement(with_joints(kMany, floating, Shape::star), 1);
}

// A rod and a plate: one principal moment is zero, or equals the sum of the others.
TEST(Extremes, ThinBodies) {
  for (const bool floating : {false, true}) {
    KinematicTree robot = with_joints(4, floating);
    model::Inertia rod;
    rod.mass = Quantity(1.5);
    rod.ixx = rod.iyy = Quantity(0.02);
    model::Inertia plate;
    plate.mass = Quantity(0.7);
    plate.ixx = Quantity(0.01);
    plate.iyy = Quantity(0.03);
    plate.izz = Quantity(0.04);
    robot.links[2].inertia = rod;
    robot.links[4].inertia = plate;
    expect_agreement(robot);
  }
}

// Neighbouring links differ by six orders of magnitude.
TEST(Extremes, LightAndHeavyLinks) {
  for (const bool floating : {false, true}) {
    KinematicTree robot = with_joints(6, floating);
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      const double factor = i % 2 == 0 ? 1e3 : 1e-3;
      model::Inertia& inertia = *robot.links[i].inertia;
      for (Quantity* q :
           {&inertia.mass, &inertia.ixx, &inertia.iyy, &inertia.izz, &inertia.ixy, &inertia.ixz, &inertia.iyz})
        *q = Quantity(factor) * *q;
    }
    expect_agreement(robot);
  }
}

// A massless link between two joints, as in descriptions of universal joints.
TEST(Extremes, MasslessLinkInBetween) {
  for (const bool floating : {false, true}) {
    KinematicTree robot = with_joints(2, floating);
    robot.links[1].inertia.reset();
    robot.joints[1].placement = {{}, {Quantity(Number::pi_multiple(1, 2)), {}, {}}};
    expect_agreement(robot);
  }
}

// A robot hundreds of metres from the base: absolute positions are large, lever arms are not.
TEST(Extremes, FarFromTheBase) {
  KinematicTree robot = with_joints(5, false);
  robot.joints[0].placement.translation = {Quantity(300.0), Quantity(-200.0), Quantity(100.0)};
  expect_agreement(robot);
}

}  // namespace
}  // namespace robcogen::numeric::extremes_test
