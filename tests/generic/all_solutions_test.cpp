// All positions of an arm without a closed form, by a search over its first joint.
#include "robcogen/generic/all_solutions.h"

#include <gtest/gtest.h>
#include <offset_wrist/kernel/inverse_kinematics.h>
#include <offset_wrist/kernel/jacobians.h>
#include <offset_wrist/kernel/transforms.h>
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

// The same with kernels: samples and steps are in lanes.
struct HandWithKernels : Hand {
  using Hand::branches;
  using Hand::jacobian;
  using Hand::pose;
  template <class S>
  static void branches(const S* X, const S* reference, S* sin_q, S* cos_q, S* misfit, S* determinant) {
    offset_wrist::kernel::inverse_kinematics_fr_base_X_fr_tool(X, reference, sin_q, cos_q, misfit, determinant);
  }
  template <class S>
  static void pose(const S* q, S* X) {
    offset_wrist::kernel::homogeneous_fr_base_X_fr_tool(q, X);
  }
  template <class S>
  static void jacobian(const S* q, S* J) {
    offset_wrist::kernel::fr_base_J_fr_tool(q, J);
  }
};
static_assert(!ChainWithKernels<Hand> && ChainWithKernels<HandWithKernels>);

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

template <class>
class AllSolutions : public testing::Test {};
using Hands = testing::Types<Hand, HandWithKernels>;
TYPED_TEST_SUITE(AllSolutions, Hands);

// Every result has the pose, none is there twice, and the positions that made the pose are among them.
TYPED_TEST(AllSolutions, AreSolutions) {
  constexpr int kTargets = 300;
  std::mt19937_64 engine(31);
  int found = 0, count = 0;
  for (int i = 0; i < kTargets; ++i) {
    const Joints q = random_joints(engine);
    const Eigen::Matrix4d X = Hand::pose(q);
    const auto all = all_solutions(TypeParam(), X, Joints(Joints::Zero()));
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
TYPED_TEST(AllSolutions, AreAll) {
  std::mt19937_64 engine(32);
  int known = 0, missing = 0;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Matrix4d X = Hand::pose(random_joints(engine));
    const auto all = all_solutions(TypeParam(), X, Joints(Joints::Zero()));
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

TYPED_TEST(AllSolutions, OutOfReachThereAreNone) {
  Eigen::Matrix4d X = Hand::pose(Joints::Constant(0.5));
  X(0, 3) += 3;
  EXPECT_EQ(all_solutions(TypeParam(), X, Joints(Joints::Zero())).count, 0);
}

// The given joint stays within its range.
TYPED_TEST(AllSolutions, WithinARange) {
  SolutionsOptions<double> options;
  options.lower = 0.2;
  options.upper = 0.8;
  const Joints q = Joints::Constant(0.5);
  const auto all = all_solutions(TypeParam(), Hand::pose(q), Joints(Joints::Zero()), options);
  EXPECT_TRUE(has(all, q));
  EXPECT_LT(all.count, all_solutions(TypeParam(), Hand::pose(q), Joints(Joints::Zero())).count);
  for (int k = 0; k < all.count; ++k) {
    EXPECT_GE(all.q[static_cast<std::size_t>(k)][0], 0.2 - 1e-4);
    EXPECT_LE(all.q[static_cast<std::size_t>(k)][0], 0.8 + 1e-4);
  }
}

// In lanes or not, the samples are the same, and so are the solutions, but for rounding.
TEST(AllSolutionsInLanes, AreTheSame) {
  std::mt19937_64 engine(33);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix4d X = Hand::pose(random_joints(engine));
    const auto all = all_solutions(Hand(), X, Joints(Joints::Zero()));
    const auto in_lanes = all_solutions(HandWithKernels(), X, Joints(Joints::Zero()));
    EXPECT_EQ(all.count, in_lanes.count);
    for (int k = 0; k < all.count; ++k) EXPECT_TRUE(has(in_lanes, all.q[static_cast<std::size_t>(k)]));
  }
}

}  // namespace
}  // namespace robcogen::test
