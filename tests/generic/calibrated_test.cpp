// Compiled inverse kinematics of a calibrated arm, in double and in single precision.
#include <calibrated_arm/calibrated_arm.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "robcogen/inverse_kinematics.h"

namespace robcogen::test::calibrated_test {
namespace {

namespace arm = calibrated_arm;
using Joints = arm::JointState;

Joints random_joints(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  Joints q;
  for (int k = 0; k < q.size(); ++k) q[k] = angle(engine);
  return q;
}

Eigen::Matrix4d pose(const Joints& q) {
  return arm::transforms::homogeneous::fr_base_X_fr_tool(q);
}

template <class Branches, class State>
auto nearest(const Branches& branches, const State& reference) {
  constexpr auto& joints = arm::inverse_kinematics::fr_base_X_fr_tool_joints;
  return nearest_branch(branches, joints, arm::kJointTypes, arm::kJointLimits, reference);
}

TEST(Calibrated, BranchesHaveThePoseOfTheArmItself) {
  constexpr int kTargets = 2000;
  constexpr double kRounding = 1e-12;
  std::mt19937_64 engine(41);
  int found = 0;
  for (int i = 0; i < kTargets; ++i) {
    const Joints q = random_joints(engine);
    Eigen::Matrix4d X = pose(q);
    const auto branches = arm::inverse_kinematics::fr_base_X_fr_tool(X, q);
    for (int branch = 0; branch < 8; ++branch) {
      const Joints at =
          branch_positions(branches, arm::inverse_kinematics::fr_base_X_fr_tool_joints, arm::kJointTypes, branch, q);
      ASSERT_LT((pose(at) - X).cwiseAbs().maxCoeff(), branches.misfit[branch] + kRounding);
    }
    const auto best = nearest(branches, q);
    if (best.branch >= 0 && (best.q - q).cwiseAbs().maxCoeff() < 1e-6) ++found;
    X(0, 3) += 5.0;
    ASSERT_TRUE(arm::inverse_kinematics::fr_base_X_fr_tool(X, q).sin_q.allFinite());
  }
  EXPECT_GT(found, kTargets * 98 / 100);
}

TEST(Calibrated, SinglePrecision) {
  constexpr int kTargets = 2000;
  std::mt19937_64 engine(42);
  int found = 0;
  for (int i = 0; i < kTargets; ++i) {
    const Joints q = random_joints(engine);
    const arm::f32::JointState single = q.cast<float>();
    Eigen::Matrix4f X = pose(q).cast<float>();
    const auto branches = arm::f32::inverse_kinematics::fr_base_X_fr_tool(X, single);
    ASSERT_TRUE(branches.sin_q.allFinite() && branches.cos_q.allFinite() && branches.misfit.allFinite());
    const auto best = nearest(branches, single);
    if (best.branch < 0) continue;
    EXPECT_LT((pose(best.q.template cast<double>()) - pose(q)).cwiseAbs().maxCoeff(), best.misfit + 1e-5F);
    if ((best.q - single).cwiseAbs().maxCoeff() < 1e-2F) ++found;
  }
  EXPECT_GT(found, kTargets * 97 / 100);
}

}  // namespace
}  // namespace robcogen::test::calibrated_test
