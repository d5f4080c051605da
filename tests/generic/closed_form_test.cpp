// Compiled inverse kinematics in closed form, and the choice among its branches.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "robcogen/inverse_kinematics.h"
#include "robots.h"

namespace robcogen::test::closed_form_test {
namespace {

namespace ik = puma560::inverse_kinematics;
using Joints = puma560::JointState;
using Limits = std::array<JointLimits, 6>;

constexpr int kTargets = 500;
constexpr double kPi = 3.14159265358979323846;

Eigen::Matrix4d pose(const Joints& q) {
  return puma560::transforms::homogeneous::fr_base_X_fr_ee(q);
}

auto nearest(const Joints& q, const Joints& reference, const Limits& limits) {
  const auto branches = ik::fr_base_X_fr_ee(pose(q), reference);
  return nearest_branch(branches, ik::fr_base_X_fr_ee_joints, puma560::kJointTypes, limits, reference);
}

TEST(ClosedForm, PositionsOfPosesAreThePositions) {
  std::mt19937_64 engine(21);
  for (int i = 0; i < kTargets; ++i) {
    const Joints q = uniform_joints<Joints>(engine, 3.1);
    const Eigen::Matrix4d X = pose(q);
    const auto branches = ik::fr_base_X_fr_ee(X, q);
    const auto all = branch_positions(branches, ik::fr_base_X_fr_ee_joints, puma560::kJointTypes);
    for (int branch = 0; branch < 8; ++branch) {
      const Joints found = branch_positions(branches, ik::fr_base_X_fr_ee_joints, puma560::kJointTypes, branch, q);
      ASSERT_LT((all.col(branch) - found).cwiseAbs().maxCoeff(), 1e-14);
      ASSERT_LT(branches.misfit[branch], 1e-9);
      ASSERT_LT((pose(found) - X).cwiseAbs().maxCoeff(), 1e-12);
      ASSERT_NEAR(branches.determinant[branch], puma560::jacobians::fr_base_J_fr_ee(found).determinant(), 1e-10);
    }
    const auto best = nearest(q, q, {});
    ASSERT_GE(best.branch, 0);
    EXPECT_LT((best.q - q).cwiseAbs().maxCoeff(), 1e-8);
    const auto one = ik::branch::fr_base_X_fr_ee(X, ik::configuration::fr_base_X_fr_ee(q), q);
    EXPECT_LT((one.q - q).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT(one.misfit[0], 1e-9);
  }
}

TEST(ClosedForm, ChoosesWithinLimits) {
  std::mt19937_64 engine(22);
  Limits limits;
  for (JointLimits& limit : limits) limit.lower = -1.2, limit.upper = 2.5;
  int elsewhere = 0;
  for (int i = 0; i < kTargets; ++i) {
    const Joints q = 1.85 * uniform_joints<Joints>(engine, 1) + Joints::Constant(0.65);
    const auto best = nearest(q, uniform_joints<Joints>(engine, 3), limits);
    ASSERT_GE(best.branch, 0);
    EXPECT_LT((pose(best.q) - pose(q)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GE(best.q.minCoeff(), -1.2 - 1e-9);
    EXPECT_LE(best.q.maxCoeff(), 2.5 + 1e-9);
    elsewhere += (best.q - q).norm() > 0.1;
  }
  EXPECT_GT(elsewhere, 0) << "the reference is not the position itself";
  limits[0].lower = 1.0;
  limits[0].upper = 1.1;
  EXPECT_EQ(nearest(Joints::Constant(0.5), Joints::Zero(), limits).branch, -1);
  EXPECT_EQ(nearest(Joints::Constant(0.5), Joints::Zero(), limits).q, Joints::Zero());
}

TEST(ClosedForm, TakesWholeTurns) {
  const Joints q = Joints::Constant(0.5), far = Joints::Constant(0.5 + 4 * kPi + 0.1);
  EXPECT_LT((nearest(q, far, {}).q - Joints::Constant(0.5 + 4 * kPi)).norm(), 1e-9);
  Limits limits;
  for (JointLimits& limit : limits) limit.lower = -1, limit.upper = 7.5;
  EXPECT_LT((nearest(q, far, limits).q - Joints::Constant(0.5 + 2 * kPi)).norm(), 1e-9);
}

// A joint at its limit, or that cannot move, is found there in spite of rounding, and not beyond.
TEST(ClosedForm, JointsAtTheirLimits) {
  std::mt19937_64 engine(24);
  for (const double half : {0.0, 1e-3, 0.5, 1.5, 3.1415})
    for (int i = 0; i < kTargets; ++i) {
      const Joints q = uniform_joints<Joints>(engine, 3.1);
      const auto joint = static_cast<std::size_t>(i % 6);
      Limits limits;
      limits[joint].lower = q[i % 6] - 2 * half;
      limits[joint].upper = q[i % 6];
      const auto best = nearest(q, q, limits);
      ASSERT_GE(best.branch, 0) << half;
      ASSERT_LT((best.q - q).cwiseAbs().maxCoeff(), 1e-7) << half;
      ASSERT_TRUE(best.q[i % 6] >= limits[joint].lower && best.q[i % 6] <= limits[joint].upper) << half;
    }
  Limits empty;
  empty[0].lower = 0.6;
  empty[0].upper = 0.4;
  EXPECT_EQ(nearest(Joints::Constant(0.5), Joints::Constant(0.5), empty).branch, -1);
}

TEST(ClosedForm, OutOfReachNoBranchExists) {
  Eigen::Matrix4d X = pose(Joints::Constant(0.5));
  X(0, 3) += 3;
  const auto branches = ik::fr_base_X_fr_ee(X, Joints::Zero());
  EXPECT_TRUE(branches.sin_q.allFinite() && branches.cos_q.allFinite());
  const auto best =
      nearest_branch(branches, ik::fr_base_X_fr_ee_joints, puma560::kJointTypes, Limits(), Joints(Joints::Zero()));
  EXPECT_EQ(best.branch, -1);
  EXPECT_GT(best.misfit, 1.0);
}

TEST(ClosedForm, InSinglePrecision) {
  using Floats = puma560::f32::JointState;
  std::mt19937_64 engine(23);
  for (int i = 0; i < kTargets; ++i) {
    const Floats q = uniform_joints<Joints>(engine, 3.1).cast<float>();
    const Eigen::Matrix4f X = puma560::f32::transforms::homogeneous::fr_base_X_fr_ee(q);
    const auto branches = puma560::f32::inverse_kinematics::fr_base_X_fr_ee(X, q);
    for (int branch = 0; branch < 8; ++branch) {
      const Floats found = branch_positions(branches, ik::fr_base_X_fr_ee_joints, puma560::kJointTypes, branch, q);
      EXPECT_LT((puma560::f32::transforms::homogeneous::fr_base_X_fr_ee(found) - X).cwiseAbs().maxCoeff(), 1e-5F);
    }
  }
}

}  // namespace
}  // namespace robcogen::test::closed_form_test
