// Damped least squares reaches poses that are reachable.
#include "robcogen/generic/inverse_kinematics.h"

#include "linear_algebra.h"
#include "robots.h"

namespace robcogen::test::inverse_kinematics_test {
namespace {

struct HylFoot {
  using JointState = hyl::JointState;
  static auto pose(const JointState& q) { return hyl::transforms::homogeneous::fr_base_X_fr_foot(q); }
  static auto jacobian(const JointState& q) { return hyl::jacobians::fr_base_J_fr_foot(q); }
  static constexpr auto kColumns = hyl::jacobians::fr_base_J_fr_foot_columns;
};
struct PumaHand {
  using JointState = puma560::JointState;
  static auto pose(const JointState& q) { return puma560::transforms::homogeneous::fr_base_X_fr_ee(q); }
  static auto jacobian(const JointState& q) { return puma560::jacobians::fr_base_J_fr_ee(q); }
  static constexpr auto kColumns = puma560::jacobians::fr_base_J_fr_ee_columns;
};
struct QuadrupedFoot {
  using JointState = quadruped::JointState;
  static auto pose(const JointState& q) { return quadruped::transforms::homogeneous::fr_trunk_X_fr_RH_foot(q); }
  static auto jacobian(const JointState& q) { return quadruped::jacobians::fr_trunk_J_fr_RH_foot(q); }
  static constexpr auto kColumns = quadruped::jacobians::fr_trunk_J_fr_RH_foot_columns;
};
// One hand with respect to the other: the columns belong to both arms.
struct TorsoHands {
  using JointState = torso::JointState;
  static auto pose(const JointState& q) { return torso::transforms::homogeneous::fr_left_palm_X_fr_right_palm(q); }
  static auto jacobian(const JointState& q) { return torso::jacobians::fr_left_palm_J_fr_right_palm(q); }
  static constexpr auto kColumns = torso::jacobians::fr_left_palm_J_fr_right_palm_columns;
};

static_assert(KinematicChain<HylFoot> && KinematicChain<TorsoHands>);

template <class Chain>
class InverseKinematics : public ::testing::Test {};
#if ROBCOGEN_TEST_EVERYTHING
using Chains = ::testing::Types<HylFoot, PumaHand, QuadrupedFoot, TorsoHands>;
#else
using Chains = ::testing::Types<PumaHand, TorsoHands>;
#endif
TYPED_TEST_SUITE(InverseKinematics, Chains);

constexpr double kDamping = 1e-8;
constexpr int kSteps = 200;
constexpr int kTargets = 200;
// rad and m together; rounding of poses that are some metres and joints away.
constexpr double kReached = 1e-9;

// Steps slow down where the Jacobian loses rank, and there may be no way out of a singularity: targets and starts keep
// this distance from one.
constexpr double kSmallestSingularValue = 0.03;

template <class Chain>
typename Chain::JointState regular_joints(
    std::mt19937_64& engine,
    const typename Chain::JointState& about,
    double limit) {
  while (true) {
    const typename Chain::JointState q = about + uniform_joints<typename Chain::JointState>(engine, limit);
    if (singular_values(Chain::jacobian(q)).minCoeff() > kSmallestSingularValue) return q;
  }
}

TYPED_TEST(InverseKinematics, ReachesRandomTargets) {
  using Joints = typename TypeParam::JointState;
  const TypeParam chain;
  std::mt19937_64 engine(11);
  for (int i = 0; i < kTargets; ++i) {
    // The target is the pose for joints up to half a radian away, so that it can be reached.
    const Joints start = regular_joints<TypeParam>(engine, Joints::Zero(), 3);
    const Eigen::Matrix4d target = chain.pose(regular_joints<TypeParam>(engine, start, 0.5));
    Joints q = start;
    int steps = 0;
    while (pose_error<double>(chain.pose(q), target).norm() > kReached && steps <= kSteps) {
      q = inverse_kinematics_step(chain, q, target, kDamping);
      ++steps;
    }
    EXPECT_LE(steps, kSteps) << "target " << i;
  }
}

TYPED_TEST(InverseKinematics, LeavesOtherJointsAlone) {
  using Joints = typename TypeParam::JointState;
  const TypeParam chain;
  std::mt19937_64 engine(12);
  const Joints q = uniform_joints<Joints>(engine, 1);
  const Joints moved = inverse_kinematics_step(chain, q, chain.pose(uniform_joints<Joints>(engine, 1)), kDamping);
  Joints in_chain = Joints::Zero();
  for (const auto joint : TypeParam::kColumns) in_chain[static_cast<int>(joint)] = 1;
  EXPECT_GT((moved - q).norm(), 1e-3);
  for (int j = 0; j < q.size(); ++j) {
    if (in_chain[j] == 0) {
      EXPECT_EQ(moved[j], q[j]) << j;
    }
  }
}

// Out of reach, and at the singularity of the stretched knee, the step stays finite and short.
TEST(InverseKinematics, IsDampedAtSingularities) {
  const HylFoot chain;
  Eigen::Matrix4d target = chain.pose(hyl::JointState::Zero());
  target(0, 3) += 5;
  hyl::JointState q = hyl::JointState::Zero();
  for (int i = 0; i < 50; ++i) {
    const hyl::JointState next = inverse_kinematics_step(chain, q, target, kDamping);
    ASSERT_TRUE(next.allFinite());
    // |J^T (J J^T + mu)^-1 e| <= |e| / (2 sqrt(mu)) <= 1 / sqrt(2), as mu is at least |e|^2 / 2.
    ASSERT_LE((next - q).norm(), 0.7072);
    q = next;
  }
}

// Targets are drawn within the limits, which are narrow: a start outside, few steps, and joints at their limits.
TYPED_TEST(InverseKinematics, FindsPositionsWithinLimits) {
  using Joints = typename TypeParam::JointState;
  const TypeParam chain;
  std::mt19937_64 engine(13);
  InverseKinematicsOptions<Joints> options;
  options.lower = Joints::Constant(-2);
  options.upper = Joints::Constant(1.5);
  int found = 0;
  for (int i = 0; i < kTargets; ++i) {
    const Joints solution = 1.75 * uniform_joints<Joints>(engine, 1) - Joints::Constant(0.25);
    const Eigen::Matrix4d target = chain.pose(solution);
    const auto result = inverse_kinematics(chain, Joints(Joints::Constant(3)), target, options);
    found += result.found;
    for (const auto joint : TypeParam::kColumns) {
      const int j = static_cast<int>(joint);
      ASSERT_TRUE(result.q[j] >= options.lower[j] && result.q[j] <= options.upper[j]) << j;
    }
    if (result.found) {
      ASSERT_LT(pose_error<double>(chain.pose(result.q), target).norm(), 3e-9);
    }
  }
  EXPECT_GE(found, kTargets * 98 / 100);
}

// Out of reach: the number of steps is bounded, and the result is the nearest position that was met.
TEST(InverseKinematics, EndsOutOfReach) {
  Eigen::Matrix4d target = HylFoot::pose(hyl::JointState::Zero());
  target(1, 3) += 1;
  const auto result = inverse_kinematics(HylFoot(), hyl::JointState(hyl::JointState::Zero()), target);
  EXPECT_FALSE(result.found);
  EXPECT_TRUE(result.q.allFinite());
  EXPECT_EQ(result.steps, 16 * 20);
  EXPECT_NEAR(result.error, 1 / 0.3, 0.2);
}

// A range of more than one turn: the position is that within limits.
TEST(InverseKinematics, TakesWholeTurns) {
  InverseKinematicsOptions<puma560::JointState> options;
  options.lower = puma560::JointState::Constant(2);
  options.upper = puma560::JointState::Constant(2 + 6.3);
  std::mt19937_64 engine(14);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix4d target = PumaHand::pose(uniform_joints<puma560::JointState>(engine, 3));
    const auto result =
        inverse_kinematics(PumaHand(), puma560::JointState(puma560::JointState::Zero()), target, options);
    EXPECT_TRUE(result.found) << i;
    EXPECT_GE(result.q.minCoeff(), 2);
    EXPECT_LE(result.q.maxCoeff(), 8.3);
  }
}

TEST(PoseError, IsTheTurnAndTheDisplacement) {
  Eigen::Isometry3d from = Eigen::Isometry3d::Identity(), to = Eigen::Isometry3d::Identity();
  from.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Eigen::Vector3d axis = Eigen::Vector3d(-2, 1, 0.5).normalized();
  to.linear() = Eigen::AngleAxisd(1.2, axis) * from.linear();
  to.translation() << 0.1, 0.2, 0.3;
  const Eigen::Matrix<double, 6, 1> error = pose_error<double>(from.matrix(), to.matrix());
  EXPECT_LT((error.head<3>() - 1.2 * axis).norm(), 1e-14);
  EXPECT_LT((error.tail<3>() - to.translation()).norm(), 1e-15);
}

}  // namespace
}  // namespace robcogen::test::inverse_kinematics_test
