// All positions of an arm without a closed form, by a search over its first joint.
#include "robcogen/generic/all_solutions.h"

#include <gtest/gtest.h>
#include <offset_wrist/offset_wrist.h>

#include <algorithm>
#include <random>
#include <vector>

namespace robcogen::test {
namespace {

struct Hand {
  using JointState = offset_wrist::JointState;
  static auto pose(const JointState& q) { return offset_wrist::transforms::homogeneous::fr_base_X_fr_tool(q); }
  static auto jacobian(const JointState& q) { return offset_wrist::jacobians::fr_base_J_fr_tool(q); }
  static constexpr auto kColumns = offset_wrist::jacobians::fr_base_J_fr_tool_columns;
  static constexpr auto kGiven = offset_wrist::Joint::J1;
  static constexpr auto kJoints = offset_wrist::inverse_kinematics::fr_base_X_fr_tool_joints;
  static constexpr auto kTypes = offset_wrist::kJointTypes;
  static auto branches(const Eigen::Matrix4d& X, const JointState& reference) {
    return offset_wrist::inverse_kinematics::fr_base_X_fr_tool(X, reference);
  }
};
using Joints = Hand::JointState;

constexpr double kPi = 3.14159265358979323846;

Joints random_joints(std::mt19937_64& engine) {
  Joints q;
  for (int k = 0; k < 6; ++k) q[k] = kPi * (2 * static_cast<double>(engine() >> 11) * 0x1p-53 - 1);
  return q;
}

bool are_same(const Joints& a, const Joints& b) {
  double largest = 0;
  for (int k = 0; k < 6; ++k) largest = std::max(largest, std::abs(std::remainder(a[k] - b[k], 2 * kPi)));
  return largest < 1e-4;
}

bool has(const Solutions<Joints>& all, const Joints& q) {
  return std::any_of(all.q.begin(), all.q.begin() + all.count, [&](const Joints& other) { return are_same(q, other); });
}

// Every result has the pose, none is there twice, and the positions that made the pose are among them.
TEST(AllSolutions, AreSolutions) {
  constexpr int kTargets = 300;
  std::mt19937_64 engine(31);
  int found = 0, count = 0;
  for (int i = 0; i < kTargets; ++i) {
    const Joints q = random_joints(engine);
    const Eigen::Matrix4d X = Hand::pose(q);
    const auto all = all_solutions(Hand(), X, Joints(Joints::Zero()));
    for (int k = 0; k < all.count; ++k) {
      const Joints& one = all.q[static_cast<std::size_t>(k)];
      ASSERT_LT((Hand::pose(one) - X).cwiseAbs().maxCoeff(), 3e-9);
      for (int other = 0; other < k; ++other) ASSERT_FALSE(are_same(one, all.q[static_cast<std::size_t>(other)]));
    }
    found += has(all, q);
    count += all.count;
  }
  EXPECT_GE(found, kTargets * 98 / 100);
  EXPECT_GE(count, 4 * kTargets);
}

// Damped steps from many random positions find no others.
TEST(AllSolutions, AreAll) {
  std::mt19937_64 engine(32);
  int known = 0, missing = 0;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Matrix4d X = Hand::pose(random_joints(engine));
    const auto all = all_solutions(Hand(), X, Joints(Joints::Zero()));
    std::vector<Joints> others;
    for (int start = 0; start < 200; ++start) {
      InverseKinematicsOptions<Joints> options;
      options.starts = 1;
      options.steps = 40;
      const auto one = inverse_kinematics(Hand(), random_joints(engine), X, options);
      const auto is_one = [&](const Joints& other) { return are_same(one.q, other); };
      if (one.found && std::none_of(others.begin(), others.end(), is_one)) others.push_back(one.q);
    }
    for (const Joints& q : others) ++(has(all, q) ? known : missing);
  }
  EXPECT_GT(known, 40);
  EXPECT_LE(missing, known / 25);
}

TEST(AllSolutions, OutOfReachThereAreNone) {
  Eigen::Matrix4d X = Hand::pose(Joints::Constant(0.5));
  X(0, 3) += 3;
  EXPECT_EQ(all_solutions(Hand(), X, Joints(Joints::Zero())).count, 0);
}

// The given joint stays within its range.
TEST(AllSolutions, WithinARange) {
  SolutionsOptions<double> options;
  options.lower = 0.2;
  options.upper = 0.8;
  const Joints q = Joints::Constant(0.5);
  const auto all = all_solutions(Hand(), Hand::pose(q), Joints(Joints::Zero()), options);
  EXPECT_TRUE(has(all, q));
  EXPECT_LT(all.count, all_solutions(Hand(), Hand::pose(q), Joints(Joints::Zero())).count);
  for (int k = 0; k < all.count; ++k) {
    EXPECT_GE(all.q[static_cast<std::size_t>(k)][0], 0.2 - 1e-4);
    EXPECT_LE(all.q[static_cast<std::size_t>(k)][0], 0.8 + 1e-4);
  }
}

}  // namespace
}  // namespace robcogen::test
