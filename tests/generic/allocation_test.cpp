// Generic code does not allocate, like the functions that it calls.
#include "allocation_hook.h"
#include "robcogen/conversions.h"
#include "robcogen/generic/computed_torque.h"
#include "robcogen/generic/inverse_kinematics.h"
#include "robcogen/generic/simulation.h"
#include "robots.h"

namespace robcogen::test::allocation_test {
namespace {

template <class Case>
class Allocation : public ::testing::Test {};
TYPED_TEST_SUITE(Allocation, AllRobots);

TYPED_TEST(Allocation, OfControlAndSimulation) {
  using R = typename TypeParam::Robot;
  const R robot;
  std::mt19937_64 engine(3);
  State<R> state = moving_state<R>(engine);
  const auto controlled = [&](const State<R>& s) {
    return acceleration(robot, s, computed_torque(robot, s, Setpoint<R>(), critically_damped<R>(5)));
  };
  {
    const NoAllocation during("a loop of control and simulation");
    for (int i = 0; i < 10; ++i)
      state = semi_implicit_euler_step(runge_kutta_step(state, 1e-3, controlled), 1e-3, controlled);
  }
  EXPECT_TRUE(state.q.allFinite() && state.qd.allFinite());
}

TEST(Allocation, OfPosesAndConversions) {
  using State = robcogen::State<quadruped::Robot>;
  std::mt19937_64 engine(4);
  const State start = moving_state<quadruped::Robot>(engine);
  State state = start;
  Twist back;
  double qpos[7 + quadruped::kDof], qvel[6 + quadruped::kDof];
  {
    const NoAllocation during("poses and conversions");
    const auto match = match_joints(quadruped::kJointNames, quadruped::kJointNames);
    to_mujoco(state, *match.order, qpos, qvel);
    state = from_mujoco<State>(qpos, qvel, *match.order);
    back = difference(integrate(state.pose, state.base_velocity, 0.1), start.pose);
    back = Twist(difference_derivatives(state.pose, start.pose).d_to * back.vector());
  }
  EXPECT_LT((back + 0.1 * start.base_velocity).vector().norm(), 1e-14);
}

struct Palms {
  using JointState = torso::JointState;
  static auto pose(const JointState& q) { return torso::transforms::homogeneous::fr_left_palm_X_fr_right_palm(q); }
  static auto jacobian(const JointState& q) { return torso::jacobians::fr_left_palm_J_fr_right_palm(q); }
  static constexpr auto kColumns = torso::jacobians::fr_left_palm_J_fr_right_palm_columns;
};

TEST(Allocation, OfInverseKinematics) {
  const torso::JointState q = torso::JointState::Constant(0.3);
  const Eigen::Matrix4d target = Palms::pose(torso::JointState::Constant(0.4));
  torso::JointState next;
  {
    const NoAllocation during("inverse kinematics");
    next = inverse_kinematics_step(Palms(), q, target, 1e-6);
    next = inverse_kinematics(Palms(), next, target).q;
  }
  EXPECT_GT((next - q).norm(), 0);
}

}  // namespace
}  // namespace robcogen::test::allocation_test
