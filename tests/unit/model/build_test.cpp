#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "descriptions.h"

namespace robcogen::model::build_test {
namespace {

using Codes = std::vector<std::string>;

Codes codes_of(const Description& description) {
  Diagnostics diagnostics;
  const auto tree = build(description, diagnostics);
  EXPECT_EQ(tree.has_value(), !diagnostics.has_errors());
  return test::codes(diagnostics);
}

// These tests need trees of several elements; each message is in a document of tests/model/bad.

TEST(Build, LinksATree) {
  Diagnostics diagnostics;
  const auto tree = build(test::two_links(), diagnostics);
  ASSERT_TRUE(tree.has_value());
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(tree->dof(), 2);
  EXPECT_EQ(tree->joints[1].parent, 1);
  EXPECT_EQ(tree->joints[1].child, 2);
  EXPECT_EQ(tree->links[2].parent_joint, 1);
  EXPECT_EQ(tree->links[1].child_joints, std::vector<int>{1});
}

TEST(Build, AcceptsALoneBase) {
  Description d;
  d.name = "rock";
  d.base = test::link("rock");
  EXPECT_EQ(codes_of(d), Codes{});
  d.floating_base = true;
  EXPECT_EQ(codes_of(d), Codes{});
}

TEST(Build, AcceptsAFixedBaseOfAnyInertia) {
  Description d = test::two_links();
  d.base.inertia = test::ball(-1.0, -5.0);
  EXPECT_EQ(codes_of(d), Codes{});
}

TEST(Build, ReportsAllErrorsAtOnce) {
  Description d = test::two_links();
  d.links[0].children.push_back({"nowhere", "b", {}, {}});
  d.links.push_back(test::link("lost"));
  d.joints.push_back(test::joint("spare"));
  EXPECT_EQ(codes_of(d), (Codes{"unknown-link", "joint-used-twice", "joint-unused", "island"}));
}

TEST(Build, ReportsACycleBesideTheTreeOnce) {
  Description d = test::two_links();
  d.links.push_back(test::link("x", {{"y", "xy", {}, {}}}));
  d.links.push_back(test::link("y", {{"x", "yx", {}, {}}, {"tail", "t", {}, {}}}));
  d.links.push_back(test::link("tail"));
  for (const char* name : {"xy", "yx", "t"}) d.joints.push_back(test::joint(name));
  Diagnostics diagnostics;
  EXPECT_FALSE(build(d, diagnostics).has_value());
  ASSERT_EQ(test::codes(diagnostics), Codes{"cycle"});
  EXPECT_EQ(diagnostics.all()[0].message, "links form a cycle: 'x' -> 'y' -> 'x'");
}

TEST(Build, DoesNotReportTwiceWhatAMisspeltNameMeant) {
  Description d = test::two_links();
  d.links[0].children[0].link = "twoo";
  EXPECT_EQ(codes_of(d), Codes{"unknown-link"});
  d = test::two_links();
  d.joints[1].name = "ankle";
  d.links[0].children[0].joint = "ankl";
  EXPECT_EQ(codes_of(d), Codes{"unknown-joint"});
}

TEST(Build, AcceptsIdsFromZeroOneAndTwo) {
  for (const int first : {0, 1, 2}) {
    Description d = test::two_links();
    d.links[0].id = first;
    d.links[1].id = first + 1;
    EXPECT_EQ(codes_of(d), Codes{}) << first;
    std::swap(d.links[0].id, d.links[1].id);
    EXPECT_EQ(codes_of(d), Codes{"child-before-parent"}) << first;
  }
  Description d = test::two_links();
  d.links[0].id = 3, d.links[1].id = 4;
  EXPECT_EQ(codes_of(d), Codes{"gapped-ids"});
  d.links[0].id = std::numeric_limits<int>::min(), d.links[1].id = std::numeric_limits<int>::max();
  EXPECT_EQ(codes_of(d), Codes{"gapped-ids"});
}

TEST(Build, MovesTheReferenceIntoTheInertia) {
  Description d = test::two_links();
  Placement placement;
  placement.translation[2] = test::number(0.25);
  d.links[1].frames = {{"com", placement, {}}};
  d.links[1].reference_frame = "com";
  Diagnostics diagnostics;
  const auto tree = build(d, diagnostics);
  ASSERT_TRUE(tree.has_value());
  EXPECT_EQ(in_link_frame(*tree->links[2].inertia).first_moment[2].number().value(), 0.25);
}

// Large enough that quadratic time (hours) or a call stack as deep as the chain would show.
constexpr int kMany = 100000;

TEST(BuildLarge, AChain) {
  Diagnostics diagnostics;
  const auto tree = build(test::chain(kMany), diagnostics);
  ASSERT_TRUE(tree.has_value());
  EXPECT_TRUE(diagnostics.all().empty());
  const std::vector<int> order = tree->topological();
  ASSERT_EQ(order.size(), static_cast<std::size_t>(kMany));
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

// Large enough for quadratic time to show, small enough for a build with sanitizers.
constexpr int kSeveral = 25000;

TEST(BuildLarge, AStar) {
  Description d;
  d.name = "star";
  d.base = test::link("base");
  for (int i = 0; i < kSeveral; ++i) {
    const std::string name = std::to_string(i);
    d.base.children.push_back({"l" + name, "j" + name, {}, {}});
    d.links.push_back(test::link("l" + name));
    d.joints.push_back(test::joint("j" + name));
  }
  EXPECT_EQ(codes_of(d), Codes{});
}

TEST(BuildLarge, AChainOfUnknownNames) {
  Description d = test::chain(kSeveral);
  for (DescribedLink& link : d.links) {
    for (DescribedChild& child : link.children) child.link += "x";
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(build(d, diagnostics).has_value());
  EXPECT_GE(diagnostics.error_count(), static_cast<std::size_t>(kSeveral - 1));
}

TEST(BuildLarge, ACycle) {
  Description d = test::chain(kSeveral);
  d.links.back().children = d.base.children;
  d.base.children.clear();
  EXPECT_EQ(codes_of(d), Codes{"cycle"});
}

}  // namespace
}  // namespace robcogen::model::build_test
