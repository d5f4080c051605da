#include <gtest/gtest.h>

#include <algorithm>

#include "inertia_reference.h"

namespace robcogen::model::inertia_matrix_test {
namespace {

using Codes = std::vector<std::string>;
using test::number;
using test::pi;

// Returns the reasons why the joint-space inertia matrix is singular: one for each joint, and one for the base.
std::vector<std::string> messages(const Description& d) {
  Diagnostics diagnostics;
  EXPECT_TRUE(build(d, diagnostics).has_value()) << diagnostics.render();
  std::vector<std::string> result;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    EXPECT_NE(diagnostic.severity, Severity::error) << diagnostic.message;
    if (diagnostic.code == "singular-inertia")
      for (const Note& note : diagnostic.notes) result.push_back(note.message);
  }
  return result;
}

const Codes kNone;
const std::string kBase = "floating base 'base' has no effective inertia in some direction while the joints are free";

TEST(InertiaMatrix, NamesTheJointOfAMasslessLeaf) {
  Description d = test::two_links();
  d.links[1] = test::massless("two");
  EXPECT_EQ(messages(d), Codes{"nothing that joint 'b' moves has inertia about its axis"});
  d.joints[1].type = JointType::prismatic;
  EXPECT_EQ(messages(d), Codes{"nothing that joint 'b' moves has mass"});
}

TEST(InertiaMatrix, NamesTheJointThatTurnsAPointMassOnItsAxis) {
  Description d = test::two_links();
  d.links[1].inertia = test::ball(1.0, 0.0);
  d.links[1].inertia->com[2] = number(0.3);
  EXPECT_EQ(messages(d), Codes{"nothing that joint 'b' moves has inertia about its axis"});
  d.links[1].inertia->com[0] = number(1e-3);  // slightly off the axis
  d.links[1].inertia->ixx = d.links[1].inertia->iyy = number(0.09);
  d.links[1].inertia->izz = number(1e-6);
  EXPECT_EQ(messages(d), kNone);
}

TEST(InertiaMatrix, AcceptsAMasslessLinkInTheMiddle) {
  Description d = test::two_links();
  d.links[0] = test::massless("one", {{"two", "b", {}, {}}});
  d.joints[1].placement.rotation[0] = pi(1, 2);
  EXPECT_EQ(messages(d), kNone);
}

TEST(InertiaMatrix, RefusesAMasslessLinkBetweenTwoJointsOfOneAxis) {
  Description d = test::two_links();
  d.links[0] = test::massless("one", {{"two", "b", {}, {}}});
  d.joints[1].placement.translation[2] = number(0.7);  // along the axis
  EXPECT_EQ(messages(d), Codes{"joint 'a' has no effective inertia while the joints beyond it are free"});
}

TEST(InertiaMatrix, AcceptsASingularityOfOnePositionOnly) {
  // A massless universal joint is singular only where its axes line up.
  Description d = test::chain(3);
  d.links[0] = test::massless("l0", d.links[0].children);
  d.links[1] = test::massless("l1", d.links[1].children);
  for (DescribedJoint& joint : d.joints) joint.placement = {};
  d.joints[1].placement.rotation[0] = pi(1, 2);
  d.joints[2].placement.rotation[0] = pi(-1, 2);  // a third axis, parallel to the first at q = 0
  EXPECT_EQ(messages(d), kNone);
}

TEST(InertiaMatrix, AcceptsAMasslessFloatingBaseThatTheLegsHold) {
  Description d;
  d.name = "legs";
  d.floating_base = true;
  d.base = test::massless("base", {{"left", "a", {}, {}}, {"right", "b", {}, {}}});
  d.links = {test::link("left"), test::link("right")};
  d.joints = {test::joint("a"), test::joint("b")};
  EXPECT_EQ(messages(d), Codes{kBase});  // joints with the same axis leave the base free to turn about it
  d.joints[1].placement.rotation[0] = pi(1, 2);
  EXPECT_EQ(messages(d), kNone);
}

TEST(InertiaMatrix, RefusesAMasslessFloatingBase) {
  Description d;
  d.name = "nothing";
  d.base = test::massless("base");
  EXPECT_EQ(messages(d), kNone);
  d.floating_base = true;
  EXPECT_EQ(test::codes_of(d), Codes{"no-inertia"});
  d.base.inertia = test::ball(1.0, 0.0);  // a point mass can turn freely
  EXPECT_EQ(messages(d), Codes{kBase});
}

TEST(InertiaMatrix, NamesWhatIsMissingWithTheRobotAsOneBody) {
  Description d;
  d.name = "point";
  d.floating_base = true;
  d.base = test::link("base");
  Diagnostics none;
  EXPECT_FALSE(build(d, none)->inertia_defects.locked_base);
  d.base.inertia = test::ball(1.0, 0.0);
  Diagnostics diagnostics;
  const InertiaDefects defects = build(d, diagnostics)->inertia_defects;
  EXPECT_TRUE(defects.free_base);
  EXPECT_TRUE(defects.locked_base);
  EXPECT_FALSE(defects.no_mass);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_NE(diagnostics.all()[0].message.find("inverse dynamics of the free base"), std::string::npos);
}

TEST(InertiaMatrix, KnowsARobotOfKinematicsAlone) {
  Description d = test::two_links();
  d.links[0] = test::massless("one", {{"two", "b", {}, {}}});
  d.links[1].inertia = test::ball(0.0, 0.0);
  d.base.inertia = test::ball();  // the inertia of a fixed base, which nothing moves
  EXPECT_EQ(test::codes_of(d), (Codes{"zero-mass", "no-inertia"}));
  d.links[1].inertia->izz = number(0.1);  // a flywheel without a mass
  const Codes codes = test::codes_of(d);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "no-inertia"), 0);
  EXPECT_EQ(std::count(codes.begin(), codes.end(), "no-mass"), 1);
}

TEST(InertiaMatrix, TakesParametersForPositive) {
  Description d = test::two_links();
  d.parameters = {{"m", ParameterKind::inertial, {}, {}}, {"i", ParameterKind::inertial, {}, {}}};
  d.links[1].inertia = Inertia();
  d.links[1].inertia->mass = Quantity::parameter(0);
  EXPECT_EQ(messages(d), Codes{"nothing that joint 'b' moves has inertia about its axis"});
  d.links[1].inertia->izz = Quantity::parameter(1);
  EXPECT_EQ(messages(d), kNone);
  d.links[1].inertia->izz = Quantity::parameter(1) * Quantity();
  EXPECT_EQ(messages(d), Codes{"nothing that joint 'b' moves has inertia about its axis"});
}

TEST(InertiaMatrix, JudgesSmallThingsOnLargeOnesByTheirOwnSize) {
  // A finger of a milligram on an excavator.
  Description d = test::two_links();
  d.links[0].inertia = test::ball(1e5, 1e6);
  d.joints[1].placement.translation = {number(10.0), number(3.0), number(-2.0)};
  d.links[1].inertia = test::ball(1e-6, 1e-13);
  EXPECT_EQ(messages(d), kNone);
  // A nearly massless link in the middle of one axis.
  d = test::two_links();
  d.links[0].inertia = test::ball(1e-9, 1e-9);
  EXPECT_EQ(messages(d), kNone);
}

TEST(InertiaMatrix, AcceptsALongChain) {
  EXPECT_EQ(messages(test::chain(2000)), kNone);
}

// --- random robots with many reasons to be singular, against the rank of the matrix itself ---------------------

TEST(InertiaMatrix, AgreesWithTheRankOfTheMatrixOnRandomRobots) {
  constexpr std::uint64_t kSeed = 90125;
  std::mt19937_64 engine(kSeed);
  const auto pick = [&](int below) { return static_cast<int>(engine() % static_cast<unsigned>(below)); };
  std::uniform_real_distribution<double> any(-2.5, 2.5);
  int singular = 0;
  constexpr int kRounds = 2000;
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    Description d;
    d.name = "random";
    d.floating_base = pick(3) == 0;
    // Massless, a point mass (on or off the axis), a rod along x or z, or a ball; no borderline cases.
    const auto random_inertia = [&]() -> std::optional<Inertia> {
      Inertia i = test::ball(1.0, 0.0);
      switch (pick(6)) {
        case 0:
        case 1:
          return std::nullopt;
        case 2:
          return i;
        case 3:
          i.com[0] = number(0.5);
          i.iyy = i.izz = number(0.25);
          return i;
        case 4:
          i.ixx = i.iyy = number(0.2);
          return i;
        default:
          return test::ball();
      }
    };
    d.base = test::massless("base");
    d.base.inertia = random_inertia();
    const int n = 1 + pick(6);
    std::vector<int> parents;
    for (int i = 0; i < n; ++i) {
      const std::string name = std::to_string(i);
      const int parent = pick(3) == 0 ? pick(i + 1) : i;
      parents.push_back(parent);
      (parent == 0 ? d.base : d.links[static_cast<std::size_t>(parent - 1)])
          .children.push_back({"l" + name, "j" + name, {}, {}});
      d.links.push_back(test::massless("l" + name));
      d.links.back().inertia = random_inertia();
      Placement placement;
      for (Quantity& angle : placement.rotation) angle = pi(pick(3) == 0 ? 1 : 0, 2);
      for (Quantity& length : placement.translation) length = number(pick(3) == 0 ? 1.0 : 0.0);
      d.joints.push_back(test::joint("j" + name, pick(3) == 0 ? JointType::prismatic : JointType::revolute, placement));
    }
    int expected = n + 6;
    for (int position = 0; position < 3; ++position) {
      const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(n, [&] { return any(engine); });
      expected = std::min(expected, test::nullity(test::inertia_matrix(d, parents, q)));
    }
    Diagnostics diagnostics;
    const std::optional<KinematicTree> tree = build(d, diagnostics);
    ASSERT_TRUE(tree.has_value()) << diagnostics.render();
    const InertiaDefects& defects = tree->inertia_defects;
    EXPECT_EQ(defects.is_singular(), expected > 0) << diagnostics.render();
    if (!defects.free_base) {
      EXPECT_EQ(static_cast<int>(defects.joints.size()), expected) << diagnostics.render();
    }
    const Codes codes = test::codes(diagnostics);
    const bool is_reported = std::count(codes.begin(), codes.end(), "singular-inertia") == 1;
    EXPECT_EQ(is_reported, expected > 0 && !defects.no_inertia) << diagnostics.render();
    singular += expected > 0;
  }
  // Both outcomes must be frequent for the comparison to mean anything.
  EXPECT_GT(singular, kRounds / 10);
  EXPECT_LT(singular, kRounds * 9 / 10);
}

}  // namespace
}  // namespace robcogen::model::inertia_matrix_test
