#include "model/kinematic_tree.h"

#include <gtest/gtest.h>

#include "descriptions.h"

namespace robcogen::model::kinematic_tree_test {
namespace {

// base -a-> trunk -> (b-> arm, c-> leg -d-> foot), not declared in the order of the tree.
KinematicTree branched() {
  Description d;
  d.name = "branched";
  d.base = test::link("base", {{"trunk", "a", {}, {}}});
  d.links = {
      test::link("foot"), test::link("leg", {{"foot", "d", {}, {}}}), test::link("arm"),
      test::link("trunk", {{"arm", "b", {}, {}}, {"leg", "c", {}, {}}})};
  d.joints = {test::joint("d"), test::joint("c"), test::joint("b"), test::joint("a")};
  d.links[0].frames = {{"sole", {}, {}}, {"fr_leg", {}, {}}};
  Diagnostics diagnostics;
  const auto tree = build(d, diagnostics);
  EXPECT_TRUE(tree.has_value());
  return *tree;
}

std::vector<std::string> names(const std::vector<Frame>& frames) {
  std::vector<std::string> result;
  for (const Frame& frame : frames) result.push_back(frame.name);
  return result;
}

TEST(KinematicTree, KeepsTheOrderOfDeclaration) {
  const KinematicTree tree = branched();
  EXPECT_EQ(tree.dof(), 4);
  EXPECT_EQ(tree.links[1].name, "foot");
  EXPECT_EQ(tree.joints[3].name, "a");
  EXPECT_EQ(tree.find_link("trunk"), 4);
  EXPECT_EQ(tree.find_joint("c"), 1);
  EXPECT_EQ(tree.find_link("a"), std::nullopt);
}

TEST(KinematicTree, OrdersJointsFromTheBase) {
  const KinematicTree tree = branched();
  EXPECT_EQ(tree.topological(), (std::vector<int>{3, 2, 1, 0}));  // a b c d
  EXPECT_EQ(tree.parent_joint_of(0), 1);
  EXPECT_EQ(tree.parent_joint_of(3), -1);
}

// Joint d follows by a sum, and joint c through a loop.
TEST(KinematicTree, KnowsWhereJointsAreWhenLoopsAreAssembled) {
  KinematicTree tree = branched();
  EXPECT_EQ(tree.assembled_positions({}), std::vector<double>(4));
  tree.joints[2].assembled = 0.5;
  tree.joints[3].assembled = -2.0;
  EXPECT_EQ(tree.joints[1].assembled_position(), 0.0);
  EXPECT_EQ(tree.joints[2].assembled_position(), 0.5);
  tree.couplings = {
      {0, {{2, Quantity::parameter(0)}, {3, Quantity(1.0)}}, Quantity(0.25)},
      {1, {{2, Quantity()}}, Quantity(0.75), 0}};
  const double factor = 4.0;
  EXPECT_EQ(tree.assembled_positions({&factor, 1}), (std::vector<double>{0.25, 0.75, 0.5, -2.0}));
}

TEST(KinematicTree, NamesItsFrames) {
  const KinematicTree tree = branched();
  EXPECT_EQ(
      names(tree.frames()),
      (std::vector<std::string>{
          "fr_base", "fr_foot", "fr_leg", "fr_arm", "fr_trunk", "fr_d", "fr_c", "fr_b", "fr_a", "sole"}));
  for (const Frame& frame : tree.frames()) {
    const auto found = tree.find_frame(frame.name);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->kind, frame.kind);
    EXPECT_EQ(found->index, frame.index);
  }
  EXPECT_FALSE(tree.find_frame("leg").has_value());
}

TEST(KinematicTree, PrefersAnImplicitFrameToAUsersFrameOfItsName) {
  const KinematicTree tree = branched();
  EXPECT_TRUE(tree.user_frames[1].hidden);
  EXPECT_EQ(tree.find_frame("fr_leg")->kind, Frame::Kind::link);
}

TEST(KinematicTree, KnowsWhichLinkAFrameMovesWith) {
  const KinematicTree tree = branched();
  EXPECT_EQ(tree.link_of(*tree.find_frame("fr_d")), *tree.find_link("leg"));
  EXPECT_EQ(tree.link_of(*tree.find_frame("sole")), *tree.find_link("foot"));
  EXPECT_EQ(tree.link_of(*tree.find_frame("fr_arm")), *tree.find_link("arm"));
}

std::vector<std::string> frames_in(const DesiredTransforms& desired) {
  std::vector<std::string> names;
  for (const FramePair& pair : desired.transforms)
    if (pair.left.name == "fr_base") names.push_back(pair.right.name);
  return names;
}

TEST(DefaultDesired, IsEndsOfLimbsAndUserFramesToAndFromTheBase) {
  const KinematicTree tree = branched();
  const DesiredTransforms desired = default_desired(tree);
  // The leg has one child; the trunk has several.
  EXPECT_EQ(frames_in(desired), (std::vector<std::string>{"fr_foot", "fr_arm", "fr_trunk", "sole"}));
  EXPECT_EQ(
      frames_in(all_desired(tree)), (std::vector<std::string>{"fr_foot", "fr_leg", "fr_arm", "fr_trunk", "sole"}));
  ASSERT_EQ(desired.transforms.size(), 8u);  // both ways
  EXPECT_EQ(desired.transforms[0].left.name, "fr_base");
  EXPECT_EQ(desired.transforms[0].right.name, "fr_foot");
  EXPECT_EQ(desired.transforms[1].left.name, "fr_foot");
  ASSERT_EQ(desired.jacobians.size(), 4u);
  EXPECT_EQ(desired.jacobians[0].right.name, "fr_foot");
  EXPECT_EQ(desired.jacobians[1].right.name, "fr_arm");
  for (const FramePair& pair : desired.jacobians) EXPECT_EQ(pair.left.name, "fr_base");
}

TEST(DefaultDesired, NamesALinkByTheUserFrameOfItsName) {
  KinematicTree tree = branched();
  const auto own_frame = [&](const char* link) {
    UserFrame frame;
    frame.name = link;
    frame.link = *tree.find_link(link);
    tree.user_frames.push_back(frame);
  };
  own_frame("foot");
  own_frame("base");
  const DesiredTransforms desired = all_desired(tree);
  EXPECT_EQ(frames_in(desired), (std::vector<std::string>{"fr_leg", "fr_arm", "fr_trunk", "sole", "foot"}));

  // Next to the base's frame it is a frame like any other.
  tree.user_frames.back().placement.translation[0] = Quantity(0.5);
  EXPECT_EQ(all_desired(tree).transforms.size(), desired.transforms.size() + 2);
  // The frame of a link in the middle of a limb is left out under this name, too.
  own_frame("leg");
  EXPECT_EQ(frames_in(default_desired(tree)), (std::vector<std::string>{"fr_arm", "fr_trunk", "sole", "foot", "base"}));
}

// Frames that are named one by one have all functions, leaf or not.
TEST(DesiredOfFrames, IsEachFrameToAndFromTheBaseAndItsJacobian) {
  const KinematicTree tree = branched();
  const DesiredTransforms desired =
      desired_of_frames(tree, {*tree.find_frame("fr_base"), *tree.find_frame("fr_leg"), *tree.find_frame("fr_d")});
  std::string text;
  for (const auto* pairs : {&desired.transforms, &desired.jacobians})
    for (const FramePair& pair : *pairs) text += pair.left.name + " " + pair.right.name + "; ";
  EXPECT_EQ(text, "fr_base fr_leg; fr_leg fr_base; fr_base fr_d; fr_d fr_base; fr_base fr_leg; fr_base fr_d; ");
}

}  // namespace
}  // namespace robcogen::model::kinematic_tree_test
