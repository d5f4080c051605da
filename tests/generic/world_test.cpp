// Frames in the world: Jacobians with base columns and accelerations against finite differences of positions, wrenches
// against the transforms of forces.
#include "robcogen/world.h"

#include <gtest/gtest.h>
#include <quadruped/quadruped.h>

#include "poses.h"
#include "robcogen/generic/simulation.h"

namespace robcogen::test {
namespace {

namespace homogeneous = quadruped::transforms::homogeneous;
using Robot = quadruped::Robot;
using State = robcogen::State<Robot>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Coordinates = Eigen::Matrix<double, 6 + quadruped::kDof, 1>;

constexpr int kStates = 20;
constexpr double kStep = 1e-5;
constexpr double kDifference = 1e-8;  // central differences: squares of the step, rounding divided by it
constexpr double kRounding = 1e-12;   // moments of some hundreds of N m

State random_state(std::mt19937_64& engine) {
  State state;
  for (double& x : state.q) x = reference::uniform(engine, 1.0);
  for (double& x : state.qd) x = reference::uniform(engine, 1.0);
  state.pose = random_pose<double>(engine);
  state.base_velocity = Twist(random_vector<double>(engine), random_vector<double>(engine));
  return state;
}

Coordinates velocity_of(const State& s) {
  return (Coordinates() << s.base_velocity.vector(), s.qd).finished();
}

Eigen::Matrix<double, 6, 6 + quadruped::kDof> foot_jacobian(const State& s) {
  return jacobian_with_base<quadruped::kDof>(
      homogeneous::fr_trunk_X_fr_LF_foot(s.q), quadruped::jacobians::fr_trunk_J_fr_LF_foot(s.q),
      quadruped::jacobians::fr_trunk_J_fr_LF_foot_columns);
}

BasePose foot_in_world(const State& s) {
  const Eigen::Matrix4d X = s.pose.homogeneous() * homogeneous::fr_trunk_X_fr_LF_foot(s.q);
  return BasePose::from_rotation(X.topLeftCorner<3, 3>(), X.topRightCorner<3, 1>());
}

// Angular velocity and velocity of the origin, world axes.
Vector6 foot_velocity(const State& s) {
  return rows_in_axes<double, 1>(s.pose.rotation(), foot_jacobian(s) * velocity_of(s));
}

// Constant accelerations for a short time; terms of the second order cancel in central differences.
State moved(const State& s, const Coordinates& acceleration, double t) {
  State result = s;
  result.q += t * s.qd;
  result.qd += t * acceleration.tail<quadruped::kDof>();
  result.pose = integrate(s.pose, s.base_velocity, t);
  result.base_velocity = Twist(s.base_velocity.vector() + t * acceleration.head<6>());
  return result;
}

TEST(World, JacobianWithBaseGivesVelocities) {
  std::mt19937_64 engine(51);
  for (int i = 0; i < kStates; ++i) {
    const State s = random_state(engine);
    const BasePose up = foot_in_world(moved(s, Coordinates::Zero(), kStep));
    const BasePose down = foot_in_world(moved(s, Coordinates::Zero(), -kStep));
    const Vector6 velocity = foot_velocity(s);
    EXPECT_LT((velocity.tail<3>() - (up.position() - down.position()) / (2 * kStep)).norm(), kDifference);
    const Eigen::Vector3d turn = foot_in_world(s).to_world_axes(difference(down, up).angular()) / (2 * kStep);
    EXPECT_LT((velocity.head<3>() - turn).norm(), kDifference);
    // In the foot's own axes the same velocity is seen turned.
    const Eigen::Matrix3d R = homogeneous::fr_trunk_X_fr_LF_foot(s.q).topLeftCorner<3, 3>();
    const Vector6 local = rows_in_axes<double, 1>(R.transpose(), foot_jacobian(s) * velocity_of(s));
    EXPECT_LT((foot_in_world(s).to_world_axes(local.tail<3>()) - velocity.tail<3>()).norm(), kRounding);
  }
}

TEST(World, BiasCompletesTheAcceleration) {
  std::mt19937_64 engine(52);
  for (int i = 0; i < kStates; ++i) {
    const State s = random_state(engine);
    Coordinates a;
    for (double& x : a) x = reference::uniform(engine, 1.0);
    const Vector6 bias = bias_acceleration_with_base(
        homogeneous::fr_trunk_X_fr_LF_foot(s.q), foot_jacobian(s),
        quadruped::jacobians::fr_trunk_Jd_qd_fr_LF_foot(s.q, s.qd), s.base_velocity, s.qd);
    const Vector6 acceleration = rows_in_axes<double, 1>(s.pose.rotation(), foot_jacobian(s) * a + bias);
    const Vector6 expected = (foot_velocity(moved(s, a, kStep)) - foot_velocity(moved(s, a, -kStep))) / (2 * kStep);
    EXPECT_LT((acceleration - expected).norm(), kDifference);
  }
}

// By the generated transform of forces, and by the power that the force has.
TEST(World, WrenchOnLinkIsTheForceAtThePoint) {
  std::mt19937_64 engine(53);
  for (int i = 0; i < kStates; ++i) {
    const State s = random_state(engine);
    const Eigen::Vector3d foot = homogeneous::fr_trunk_X_fr_LF_foot(s.q).topRightCorner<3, 1>();
    const Eigen::Vector3d force = 300 * random_vector<double>(engine);
    const Wrench wrench = wrench_on_link<double>(homogeneous::fr_trunk_X_fr_LF_lowerleg(s.q), foot, force);
    const Vector6 about_trunk = (Vector6() << foot.cross(force), force).finished();
    const Vector6 expected = quadruped::transforms::force::fr_LF_lowerleg_X_fr_trunk(s.q) * about_trunk;
    EXPECT_LT((wrench.vector() - expected).norm(), kRounding);

    quadruped::LinkWrenches external;
    external[quadruped::Link::LF_lowerleg] = wrench;
    const auto zero = quadruped::JointState::Zero();
    const Gravity gravity = gravity_in_base(s.pose);
    const SpatialAcceleration still;
    const auto with =
        quadruped::inverse_dynamics_fully_actuated(s.q, s.qd, zero, s.base_velocity, still, gravity, external);
    const auto without = quadruped::inverse_dynamics_fully_actuated(s.q, s.qd, zero, s.base_velocity, still, gravity);
    const Coordinates generalized = foot_jacobian(s).bottomRows<3>().transpose() * force;
    EXPECT_LT((without.tau - with.tau - generalized.tail<quadruped::kDof>()).norm(), kRounding);
    EXPECT_LT((without.base_wrench.vector() - with.base_wrench.vector() - generalized.head<6>()).norm(), kRounding);
  }
}

}  // namespace
}  // namespace robcogen::test
