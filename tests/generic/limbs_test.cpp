// Limbs of robot types, and of robots that are chosen at run time.
#include <gtest/gtest.h>
#include <hyl/hyl.h>
#include <hyl/reflection.h>
#include <quadruped/quadruped.h>
#include <quadruped/reflection.h>
#include <two_arms/reflection.h>
#include <two_arms/two_arms.h>

#include <algorithm>
#include <set>
#include <string>

#include "robcogen/any_robot.h"

namespace {

using robcogen::Limb;

// Limbs are available at compile time.
constexpr const Limb& kHindLeg = quadruped::limbs[index(quadruped::Limb::RH)];
static_assert(kHindLeg.joint("KFE") == index(quadruped::Joint::RH_KFE));
static_assert(kHindLeg.link("upperleg") == index(quadruped::Link::RH_upperleg));
static_assert(kHindLeg.frame("fr_foot") == index(quadruped::Frame::fr_RH_foot));
static_assert(kHindLeg.frame("foot") == index(quadruped::Frame::fr_RH_foot));
static_assert(kHindLeg.frame("hand") == -1);
static_assert(robcogen::limbs_of<quadruped::Robot>().size == 4);
static_assert(robcogen::limbs_of<hyl::Robot>().size == 0);

// The name of each element of a limb is that of the limb, followed by its own name in the part.
void check_names(const robcogen::reflection::Robot& robot) {
  for (const Limb& limb : robot.limbs) {
    const std::string prefix = std::string(limb.name) + "_";
    for (const auto& [own, index] : limb.links) EXPECT_EQ(robot.links[index].name, prefix + own);
    for (const auto& [own, index] : limb.joints) EXPECT_EQ(robot.joints[index].name, prefix + own);
    for (const auto& [own, index] : limb.frames) {
      const std::string name = own;
      const std::string expected = name.starts_with("fr_") ? "fr_" + prefix + name.substr(3) : prefix + name;
      EXPECT_EQ(robot.frames[index].name, expected);
    }
    EXPECT_EQ(limb.first_link, limb.links[0].index);
  }
}

TEST(Limbs, HaveTheNamesOfTheirElements) {
  check_names(quadruped::reflection::robot);
  check_names(two_arms::reflection::robot);
  EXPECT_EQ(two_arms::reflection::robot.limbs.size, 4);
}

// A hand on an arm is a limb of its own whose elements belong to the arm, too. Followers are left out.
TEST(Limbs, ContainLimbs) {
  const robcogen::Limb& arm = two_arms::limbs[index(two_arms::Limb::right)];
  const robcogen::Limb& hand = two_arms::limbs[index(two_arms::Limb::right_hand)];
  EXPECT_EQ(arm.joints.size, 5);
  EXPECT_EQ(hand.joints.size, 2);
  EXPECT_EQ(arm.joint("hand_LEFT"), hand.joint("LEFT"));
  EXPECT_EQ(hand.joint("RIGHT"), -1);
  EXPECT_EQ(arm.frame("hand_left_tip"), hand.frame("left_tip"));
  EXPECT_STREQ(hand.part, "Gripper");
}

// Each joint belongs to one limb, which contains its child link.
TEST(Limbs, ShareNoJoints) {
  const robcogen::reflection::Robot& robot = quadruped::reflection::robot;
  std::set<int> joints;
  for (const Limb& limb : robot.limbs)
    for (const robcogen::LimbElement& joint : limb.joints) {
      EXPECT_TRUE(joints.insert(joint.index).second);
      const int child = robot.joints[joint.index].child;
      EXPECT_TRUE(std::any_of(limb.links.begin(), limb.links.end(), [&](const auto& l) { return l.index == child; }));
    }
  EXPECT_EQ(static_cast<int>(joints.size()), robot.dof());
}

template <class Robot>
int count_knees(const Robot&) {
  int knees = 0;
  for (const Limb& leg : robcogen::limbs_of<Robot>()) knees += leg.joint("KFE") >= 0 ? 1 : 0;
  return knees;
}

TEST(Limbs, AreLoopedOverInGenericCode) {
  EXPECT_EQ(count_knees(quadruped::Robot()), 4);
  EXPECT_EQ(count_knees(hyl::Robot()), 0);
}

TEST(Limbs, OfRobotsThatAreChosenAtRunTime) {
  const auto robot = robcogen::make_any<quadruped::Robot>(quadruped::reflection::robot);
  ASSERT_NE(robot.find_limb("RF"), nullptr);
  EXPECT_STREQ(robot.find_limb("RF")->part, "Leg");
  EXPECT_EQ(robot.find_limb("RF")->joint("HAA"), 3);
  EXPECT_EQ(robot.find_limb("MF"), nullptr);
  EXPECT_EQ(robot.limbs().size, 4);
  EXPECT_EQ(robcogen::make_any<hyl::Robot>(hyl::reflection::robot).limbs().size, 0);
}

}  // namespace
