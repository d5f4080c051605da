// Compiled inverse kinematics of a calibrated arm of seven joints, with the swivel angle of its nominal arm.
#include <calibrated_seven/calibrated_seven.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "robcogen/inverse_kinematics.h"

namespace robcogen::test::calibrated_seven_test {
namespace {

namespace arm = calibrated_seven;
namespace ik = arm::inverse_kinematics;
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

TEST(CalibratedSeven, PositionsAreFoundByTheirSwivel) {
  constexpr int kTargets = 2000;
  constexpr double kRounding = 1e-12;
  std::mt19937_64 engine(43);
  int found = 0, followed = 0;
  for (int i = 0; i < kTargets; ++i) {
    const Joints q = random_joints(engine);
    const Eigen::Matrix4d X = pose(q);
    const auto swivel = ik::redundancy::fr_base_X_fr_tool(q);
    const auto branches = ik::fr_base_X_fr_tool(X, swivel, q);
    for (int branch = 0; branch < 8; ++branch) {
      const Joints at = branch_positions(branches, ik::fr_base_X_fr_tool_joints, arm::kJointTypes, branch, q);
      ASSERT_LT((pose(at) - X).cwiseAbs().maxCoeff(), branches.misfit[branch] + kRounding);
    }
    const auto best = nearest_branch(branches, ik::fr_base_X_fr_tool_joints, arm::kJointTypes, arm::kJointLimits, q);
    if (best.branch < 0 || best.misfit > 1e-9 || (best.q - q).cwiseAbs().maxCoeff() > 1e-7) continue;
    ++found;
    // Another angle: the pose stays, and the angle of the positions is this one.
    const Eigen::Matrix<double, 1, 1> other(swivel[0] + 0.1);
    const auto moved = ik::branch::fr_base_X_fr_tool(X, other, ik::configuration::fr_base_X_fr_tool(q), q);
    if (moved.misfit[0] > 1e-9) continue;
    const double missed = ik::redundancy::fr_base_X_fr_tool(moved.q)[0] - other[0];
    if (std::abs(std::remainder(missed, 2 * 3.14159265358979323846)) < 1e-7) ++followed;
  }
  EXPECT_GT(found, kTargets * 97 / 100);
  EXPECT_GT(followed, kTargets * 95 / 100);
}

}  // namespace
}  // namespace robcogen::test::calibrated_seven_test
