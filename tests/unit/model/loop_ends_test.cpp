// Joints between frames.
#include "model/loop_ends.h"

#include <gtest/gtest.h>

#include "descriptions.h"

namespace robcogen::model::loop_ends_test {
namespace {

// base -a-> trunk -> (b-> arm, c-> leg -d-> foot)
KinematicTree branched() {
  Description d;
  d.name = "branched";
  d.base = test::link("base", {{"trunk", "a", {}, {}}});
  d.links = {
      test::link("trunk", {{"arm", "b", {}, {}}, {"leg", "c", {}, {}}}), test::link("arm"),
      test::link("leg", {{"foot", "d", {}, {}}}), test::link("foot")};
  for (const char* name : {"a", "b", "c", "d"}) d.joints.push_back(test::joint(name));
  Diagnostics diagnostics;
  const auto tree = build(d, diagnostics);
  EXPECT_TRUE(tree.has_value());
  return *tree;
}

TEST(JointsFromBase, StandInOrder) {
  const KinematicTree tree = branched();
  EXPECT_EQ(joints_from_base(tree, 0), std::vector<int>{});
  EXPECT_EQ(joints_from_base(tree, *tree.find_link("arm")), (std::vector<int>{0, 1}));
  EXPECT_EQ(joints_from_base(tree, *tree.find_link("foot")), (std::vector<int>{0, 2, 3}));
}

TEST(LoopEnds, HaveTheJointsThatMoveOneAgainstTheOther) {
  const KinematicTree tree = branched();
  const auto ends = [&](const std::string& first, const std::string& second) {
    return ends_between(tree, *tree.find_frame(first), *tree.find_frame(second));
  };
  const std::array<LoopEnd, 2> apart = ends("fr_foot", "fr_arm");
  EXPECT_EQ(apart[0].joints, (std::vector<int>{2, 3}));
  EXPECT_EQ(apart[1].joints, std::vector<int>{1});
  EXPECT_EQ(apart[0].frame, "fr_foot");
  EXPECT_EQ(apart[1].link, *tree.find_link("arm"));
  EXPECT_EQ(ends("fr_foot", "fr_trunk")[1].joints, std::vector<int>{});
  EXPECT_EQ(ends("fr_foot", "fr_base")[0].joints, (std::vector<int>{0, 2, 3}));
  // The frame of joint d is fixed to the leg.
  for (const LoopEnd& end : ends("fr_d", "fr_leg")) EXPECT_EQ(end.joints, std::vector<int>{});
}

}  // namespace
}  // namespace robcogen::model::loop_ends_test
