// Equal limbs in trees whose limbs are known by construction.
#include "model/limbs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "descriptions.h"

namespace robcogen::model::limbs_test {
namespace {

using Names = std::vector<std::vector<std::string>>;

// A robot given by edges (parent link, joint, child link); links and joints are declared in this order.
struct Edge {
  std::string parent, joint, child;
  JointType type = JointType::revolute;
};

KinematicTree robot(const std::vector<Edge>& edges) {
  Description d;
  d.name = "robot";
  d.base = test::link("base");
  for (const Edge& e : edges) d.links.push_back(test::link(e.child));
  for (const Edge& e : edges) {
    d.joints.push_back(test::joint(e.joint, e.type));
    const auto named = [&](const DescribedLink& link) { return link.name == e.parent; };
    const auto link = std::find_if(d.links.begin(), d.links.end(), named);
    (link == d.links.end() ? d.base : *link).children.push_back({e.child, e.joint, {}, {}});
  }
  Diagnostics diagnostics;
  const auto tree = build(d, diagnostics);
  EXPECT_TRUE(tree.has_value());
  return *tree;
}

// base -> `<name>1` -> … -> `<name><length>`, with joints `<name>_j1`, …
void add_chain(std::vector<Edge>& edges, const std::string& parent, const std::string& name, int length) {
  std::string from = parent;
  for (int k = 1; k <= length; ++k) {
    const std::string number = std::to_string(k);
    edges.push_back({from, name + "_j" + number, name + number});
    from = name + number;
  }
}

Names groups(const KinematicTree& tree) {
  Names names;
  for (const std::vector<int>& group : corresponding_joints(tree)) {
    names.emplace_back();
    for (int joint : group) names.back().push_back(tree.joints[static_cast<std::size_t>(joint)].name);
  }
  return names;
}

TEST(Limbs, LegsOfAQuadrupedAreOneClass) {
  std::vector<Edge> edges;
  for (const char* leg : {"lf", "rf", "lh", "rh"}) add_chain(edges, "base", leg, 2);
  EXPECT_EQ(groups(robot(edges)), (Names{{"lf_j1", "rf_j1", "lh_j1", "rh_j1"}, {"lf_j2", "rf_j2", "lh_j2", "rh_j2"}}));
}

TEST(Limbs, ARotorOnAnotherLimbTiesTheTwo) {
  std::vector<Edge> edges;
  for (const char* leg : {"lf", "rf", "lh", "rh"}) add_chain(edges, "base", leg, 2);
  KinematicTree tree = robot(edges);
  const auto put_rotor = [&](std::size_t joint, std::size_t carrier) {
    Rotor& rotor = tree.joints[joint].drive.rotor.emplace();
    rotor.carrier = tree.joints[carrier].child;
  };
  for (const std::size_t hip : {0U, 2U, 4U, 6U}) put_rotor(hip, hip);
  EXPECT_EQ(groups(tree).size(), 2u) << "rotors on the children of their joints";
  put_rotor(0, 3);
  EXPECT_EQ(groups(tree), (Names{{"lh_j1", "rh_j1"}, {"lh_j2", "rh_j2"}}));
}

KinematicTree legs_with_couplings(const std::vector<Coupling>& couplings) {
  std::vector<Edge> edges;
  for (const char* leg : {"lf", "rf", "lh", "rh"}) add_chain(edges, "base", leg, 2);
  KinematicTree tree = robot(edges);
  tree.couplings = couplings;
  return tree;
}

Coupling coupling(int joint, int followed, double factor, double offset = 0.0) {
  return {joint, {{followed, test::number(factor)}}, test::number(offset)};
}

TEST(Limbs, WithTheSameCouplingsAreOneClass) {
  const KinematicTree tree = legs_with_couplings(
      {coupling(1, 0, 0.5, 0.1), coupling(3, 2, -0.6, 0.2), coupling(5, 4, 0.5, 0.3), coupling(7, 6, 0.5, 0.1)});
  EXPECT_EQ(groups(tree), (Names{{"lf_j1", "rf_j1", "lh_j1", "rh_j1"}, {"lf_j2", "rf_j2", "lh_j2", "rh_j2"}}));
}

TEST(Limbs, WithOtherCouplingsAreOthers) {
  // The third leg's hip follows; the fourth leg has a factor that folds.
  const KinematicTree tree =
      legs_with_couplings({coupling(1, 0, 0.5), coupling(3, 2, 0.5), coupling(4, 5, 0.5), coupling(7, 6, 1.0)});
  EXPECT_EQ(groups(tree), (Names{{"lf_j1", "rf_j1"}, {"lf_j2", "rf_j2"}}));
  EXPECT_TRUE(groups(legs_with_couplings({coupling(1, 0, 0.5), coupling(3, 2, 0.5, 0.1)})).size() == 2u)
      << "free hind legs";
}

TEST(Limbs, CoupledToEachOtherAreUnlikeAllOthers) {
  EXPECT_EQ(groups(legs_with_couplings({coupling(3, 1, 1.0)})), (Names{{"lh_j1", "rh_j1"}, {"lh_j2", "rh_j2"}}));
  EXPECT_EQ(groups(legs_with_couplings({coupling(3, 1, 1.0), coupling(7, 5, 1.0)})), Names{});
}

TEST(Limbs, HumanoidHasArmsBeyondItsWaist) {
  std::vector<Edge> edges;
  add_chain(edges, "base", "left_leg", 2);
  add_chain(edges, "base", "waist", 1);
  add_chain(edges, "base", "right_leg", 2);
  add_chain(edges, "waist1", "left_arm", 1);
  add_chain(edges, "waist1", "head", 3);
  add_chain(edges, "waist1", "right_arm", 1);
  EXPECT_EQ(
      groups(robot(edges)),
      (Names{{"left_leg_j1", "right_leg_j1"}, {"left_leg_j2", "right_leg_j2"}, {"left_arm_j1", "right_arm_j1"}}));
}

TEST(Limbs, CentaurHasTwoClassesOnOneLink) {
  std::vector<Edge> edges;
  for (const char* leg : {"a", "b", "c", "d"}) add_chain(edges, "base", leg, 3);
  for (const char* arm : {"l", "r"}) add_chain(edges, "base", arm, 6);
  const KinematicTree tree = robot(edges);
  const std::vector<LimbClass> classes = limb_classes(tree);
  ASSERT_EQ(classes.size(), 2u);
  EXPECT_EQ(classes[0].count(), 4u);
  EXPECT_EQ(classes[0].length(), 3u);
  EXPECT_EQ(classes[1].count(), 2u);
  EXPECT_EQ(classes[1].length(), 6u);
}

TEST(Limbs, AnArmHasNone) {
  std::vector<Edge> edges;
  add_chain(edges, "base", "arm", 6);
  EXPECT_TRUE(limb_classes(robot(edges)).empty());
}

TEST(Limbs, TypesOfJointsMatter) {
  const KinematicTree tree = robot({{"base", "a", "one"}, {"base", "b", "two", JointType::prismatic}});
  EXPECT_TRUE(limb_classes(tree).empty());
}

// The branches of the hands are declared in different orders; fingers correspond from hand to hand.
TEST(Limbs, BranchesOfALimbArePairedByTheirShape) {
  std::vector<Edge> edges = {{"base", "left", "left_hand"}, {"base", "right", "right_hand"}};
  add_chain(edges, "left_hand", "left_thumb", 1);
  add_chain(edges, "left_hand", "left_finger", 2);
  add_chain(edges, "right_hand", "right_finger", 2);
  add_chain(edges, "right_hand", "right_thumb", 1);
  EXPECT_EQ(
      groups(robot(edges)), (Names{
                                {"left", "right"},
                                {"left_thumb_j1", "right_thumb_j1"},
                                {"left_finger_j1", "right_finger_j1"},
                                {"left_finger_j2", "right_finger_j2"}}));
}

// Random trees, checked with the definition: types, parents and children correspond.
TEST(Limbs, OfRandomTreesCorrespond) {
  std::mt19937 random(1);
  const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Edge> edges;
    for (int k = 0, n = 1 + pick(14); k < n; ++k) {
      const int parent = pick(k + 1);
      const JointType type = pick(5) == 0 ? JointType::prismatic : JointType::revolute;
      edges.push_back(
          {parent == 0 ? "base" : "l" + std::to_string(parent - 1), "j" + std::to_string(k), "l" + std::to_string(k),
           type});
    }
    const KinematicTree tree = robot(edges);
    std::vector<int> seen(tree.joints.size(), 0);
    const auto joint = [&](int j) -> const Joint& { return tree.joints[static_cast<std::size_t>(j)]; };
    for (const LimbClass& limbs : limb_classes(tree)) {
      ++found;
      ASSERT_GE(limbs.count(), 2u);
      const std::vector<int>& first = limbs.limbs.front();
      for (const std::vector<int>& limb : limbs.limbs) {
        ASSERT_EQ(limb.size(), first.size());
        EXPECT_EQ(joint(limb[0]).parent, joint(first[0]).parent);
        for (std::size_t k = 0; k < limb.size(); ++k) {
          EXPECT_EQ(++seen[static_cast<std::size_t>(limb[k])], 1) << "in two limbs";
          EXPECT_EQ(joint(limb[k]).type, joint(first[k]).type);
          const auto place_of_parent = [&](const std::vector<int>& joints) {
            return std::find(joints.begin(), joints.end(), tree.parent_joint_of(joints[k])) - joints.begin();
          };
          EXPECT_EQ(place_of_parent(limb), place_of_parent(first));
          const auto children = [&](int j) {
            return tree.links[static_cast<std::size_t>(joint(j).child)].child_joints.size();
          };
          EXPECT_EQ(children(limb[k]), children(first[k]));
        }
      }
    }
  }
  EXPECT_GT(found, 100) << "the trees have hardly any limbs";
}

// Deep trees do not need a deep call stack.
TEST(Limbs, OfTwoLongChains) {
  std::vector<Edge> edges;
  for (const char* chain : {"a", "b"}) add_chain(edges, "base", chain, 500);
  EXPECT_EQ(limb_classes(robot(edges)).front().length(), 500u);
}

}  // namespace
}  // namespace robcogen::model::limbs_test
