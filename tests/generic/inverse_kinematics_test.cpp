// Damped least squares reaches poses that are reachable.
#include "robcogen/generic/inverse_kinematics.h"

#include <Eigen/SVD>
#include "robots.h"

namespace robcogen::test {
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
using Chains = ::testing::Types<HylFoot, PumaHand, QuadrupedFoot, TorsoHands>;
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
    if (Eigen::MatrixXd(Chain::jacobian(q)).jacobiSvd().singularValues().minCoeff() > kSmallestSingularValue) return q;
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
}  // namespace robcogen::test
