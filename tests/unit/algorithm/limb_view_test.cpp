// A robot reduced to one limb is the same mechanism as far as this limb is concerned.
#include "algorithm/search/limb_view.h"

#include <set>

#include "algorithm/dynamics/dynamics.h"
#include "algorithm/kinematics/kinematics.h"
#include "random_robots.h"

namespace robcogen::algorithm::limb_view_test {
namespace {

using namespace test;
using model::KinematicTree;

class LimbViews : public testing::TestWithParam<int> {
 protected:
  static constexpr int kJoints = 7;
  Numbers n{static_cast<unsigned>(GetParam())};
  KinematicTree tree = random_robot(n, kJoints, false);
  std::vector<double> q, qd, qdd;

  void SetUp() override {
    for (int j = 0; j < kJoints; ++j)
      for (std::vector<double>* state : {&q, &qd, &qdd}) state->push_back(n.real());
  }

  // True if a joint is on the path from the base to another joint.
  bool is_ancestor(int joint, int of) const {
    for (int j = of; j >= 0; j = tree.parent_joint_of(j))
      if (j == joint) return true;
    return false;
  }
  std::vector<double> chosen(const std::vector<double>& all, const std::vector<int>& joints) const {
    std::vector<double> result;
    for (const int j : joints) result.push_back(all[static_cast<std::size_t>(j)]);
    return result;
  }
};

TEST_P(LimbViews, HoldThePathFromTheBaseAndAllBeyond) {
  for (int joint = 0; joint < kJoints; ++joint) {
    const LimbView view = limb_view(tree, joint);
    std::set<int> expected;
    for (int j = 0; j < kJoints; ++j)
      if (is_ancestor(j, joint) || is_ancestor(joint, j)) expected.insert(j);
    EXPECT_EQ(std::set<int>(view.joints.begin(), view.joints.end()), expected);
    EXPECT_EQ(view.joints.size(), expected.size());
  }
}

TEST_P(LimbViews, AreTreesOfTheirOwn) {
  for (int joint = 0; joint < kJoints; ++joint) {
    const auto [part, joints] = limb_view(tree, joint);
    ASSERT_EQ(part.joints.size(), joints.size());
    ASSERT_EQ(part.links.size(), joints.size() + 1);
    EXPECT_EQ(part.links[0].parent_joint, -1);
    for (int j = 0; j < part.dof(); ++j) {
      const model::Joint& copy = part.joints[static_cast<std::size_t>(j)];
      const model::Joint& original = tree.joints[static_cast<std::size_t>(joints[static_cast<std::size_t>(j)])];
      const auto name = [](const KinematicTree& t, int link) { return t.links[static_cast<std::size_t>(link)].name; };
      EXPECT_EQ(copy.name, original.name);
      EXPECT_EQ(name(part, copy.parent), name(tree, original.parent));
      EXPECT_EQ(name(part, copy.child), name(tree, original.child));
      EXPECT_EQ(part.links[static_cast<std::size_t>(copy.child)].parent_joint, j);
      EXPECT_LT(part.parent_joint_of(j), j);  // parents before children
    }
  }
}

// Everything that affects a joint is in its view: its row of the inertia matrix and its inverse-dynamics force are the
// same.
TEST_P(LimbViews, FeelTheSameForces) {
  const std::vector<double> tau =
      run(newton_euler(tree, "f", Loads::standard_gravity), {{"q", q}, {"qd", qd}, {"qdd", qdd}});
  const std::vector<double> H = run(joint_space_inertia(tree, "H"), {{"q", q}});
  for (int joint = 0; joint < kJoints; ++joint) {
    const auto [part, joints] = limb_view(tree, joint);
    const auto own = static_cast<std::size_t>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
    ASSERT_LT(own, joints.size());
    const std::vector<double> part_tau =
        run(newton_euler(part, "f", Loads::standard_gravity),
            {{"q", chosen(q, joints)}, {"qd", chosen(qd, joints)}, {"qdd", chosen(qdd, joints)}});
    const double expected = tau[static_cast<std::size_t>(joint)];
    EXPECT_NEAR(part_tau[own], expected, 1e-11 * (1 + std::abs(expected)));
    const std::vector<double> part_H = run(joint_space_inertia(part, "H"), {{"q", chosen(q, joints)}});
    for (std::size_t k = 0; k < joints.size(); ++k)
      EXPECT_NEAR(part_H[own * joints.size() + k], H[static_cast<std::size_t>(joint * kJoints + joints[k])], 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(, LimbViews, testing::Range(0, 5));

}  // namespace
}  // namespace robcogen::algorithm::limb_view_test
