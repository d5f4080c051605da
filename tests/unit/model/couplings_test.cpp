// Couplings of a description, expressed in independent joints.
#include <gtest/gtest.h>

#include "descriptions.h"
#include "model/plausibility.h"
#include "model/rigid_motions.h"
#include "support/index.h"

namespace robcogen::model::couplings_test {
namespace {

DescribedCoupling coupling(
    const std::string& joint,
    const std::vector<std::pair<std::string, double>>& terms,
    double offset = 0) {
  DescribedCoupling result = {joint, {}, {}, Quantity(offset)};
  for (const auto& [name, factor] : terms) result.terms.push_back({name, Quantity(factor), {}});
  return result;
}

KinematicTree built(const Description& d) {
  Diagnostics diagnostics;
  auto tree = build(d, diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  return *tree;
}

TEST(Couplings, LeaveTheCoordinatesOfIndependentJoints) {
  Description d = test::chain(4);
  d.couplings = {coupling("j1", {{"j3", 2.0}}, 0.5)};
  const KinematicTree tree = built(d);
  EXPECT_EQ(tree.dof(), 3);
  EXPECT_EQ(tree.coordinates(), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(independent_joints_first(tree), (std::vector<int>{0, 2, 3, 1}));
  for (int k = 0; k < tree.dof(); ++k) EXPECT_EQ(tree.coordinate_of(tree.coordinates()[at(k)]), k);
  EXPECT_EQ(tree.coupling_of(0), nullptr);
  ASSERT_NE(tree.coupling_of(1), nullptr);
  EXPECT_EQ(tree.coupling_of(1)->terms.front().joint, 3);
}

TEST(Couplings, OfChainsAreComposed) {
  Description d = test::chain(4);
  // j0 = 2 j1 + 1, j1 = 3 j2 - j3 + 0.25
  d.couplings = {coupling("j0", {{"j1", 2.0}}, 1.0), coupling("j1", {{"j2", 3.0}, {"j3", -1.0}}, 0.25)};
  const KinematicTree tree = built(d);
  const Coupling& first = tree.couplings[0];
  ASSERT_EQ(first.terms.size(), 2u);
  EXPECT_EQ(first.terms[0].joint, 2);
  EXPECT_EQ(evaluate(first.terms[0].factor), 6.0);
  EXPECT_EQ(first.terms[1].joint, 3);
  EXPECT_EQ(evaluate(first.terms[1].factor), -2.0);
  EXPECT_EQ(evaluate(first.offset), 1.5);
}

TEST(Couplings, OfLongChainsNeedNoDeepStack) {
  const int length = 20000;
  Description d = test::chain(length);
  for (int i = 0; i + 1 < length; ++i)
    d.couplings.push_back(coupling("j" + std::to_string(i), {{"j" + std::to_string(i + 1), -1.0}}));
  const KinematicTree tree = built(d);
  EXPECT_EQ(tree.dof(), 1);
  EXPECT_EQ(evaluate(tree.couplings[0].terms.front().factor), length % 2 == 0 ? -1.0 : 1.0);
}

TEST(Couplings, ThatMeetAgainAreAdded) {
  Description d = test::chain(4);
  d.couplings = {
      coupling("j0", {{"j1", 1.0}, {"j2", 1.0}}), coupling("j1", {{"j3", 2.0}}), coupling("j2", {{"j3", -2.0}}, 0.1)};
  const KinematicTree tree = built(d);
  EXPECT_TRUE(tree.couplings[0].terms.empty()) << "the factors cancel: the joint stands still";
  EXPECT_EQ(evaluate(tree.couplings[0].offset), 0.1);
}

TEST(Couplings, WithFactorZeroHoldAJoint) {
  Description d = test::two_links();
  d.couplings = {coupling("a", {{"b", 0.0}}, 0.2), coupling("b", {})};
  const KinematicTree tree = built(d);
  EXPECT_EQ(tree.dof(), 0);
  EXPECT_TRUE(tree.couplings[0].terms.empty());
  EXPECT_EQ(evaluate(tree.couplings[0].offset), 0.2);
}

TEST(Couplings, AreReportedWithTheJointsOfACycle) {
  Description d = test::chain(4);
  d.couplings = {
      coupling("j0", {{"j1", 1.0}}), coupling("j1", {{"j2", 1.0}, {"j3", 1.0}}), coupling("j2", {{"j0", 1.0}})};
  Diagnostics diagnostics;
  EXPECT_FALSE(build(d, diagnostics).has_value());
  ASSERT_EQ(test::codes(diagnostics), std::vector<std::string>{"coupling-cycle"});
  EXPECT_EQ(diagnostics.all().front().message, "couplings form a cycle: 'j0' -> 'j1' -> 'j2' -> 'j0'");
}

TEST(Couplings, OfAMotionAreSubstituted) {
  Description d = test::two_links();
  d.couplings = {coupling("b", {{"a", 2.0}}, 0.5)};
  const RigidMotions motions = motions_over_coordinates(built(d));
  EXPECT_EQ(motions.variables, std::vector<std::string>{"q_a"});
  const double angle[] = {0.3};
  double turned = 0;
  for (const Motion& motion : motions.motions)
    if (motion.to == "fr_two") turned = evaluate(motion.steps.back().amount, {}, angle);
  EXPECT_EQ(turned, 1.1);
}

// A massless link between two joints with the same axis: if both are free, together they meet no inertia; if coupled,
// they do.
TEST(Couplings, DecideWhetherTheInertiaMatrixIsSingular) {
  Description d = test::two_links();
  d.links[0] = test::massless("one", {{"two", "b", {}, {}}});
  EXPECT_TRUE(inertia_defects(built(d)).is_singular());
  d.couplings = {coupling("b", {{"a", 2.0}})};
  EXPECT_FALSE(inertia_defects(built(d)).is_singular());
  d.couplings = {coupling("b", {{"a", -1.0}})};  // the second joint turns back, so nothing turns
  const InertiaDefects defects = inertia_defects(built(d));
  ASSERT_EQ(defects.joints.size(), 1u);
  EXPECT_EQ(defects.joints[0].joint, 0);
  EXPECT_TRUE(defects.joints[0].locked);
}

}  // namespace
}  // namespace robcogen::model::couplings_test
