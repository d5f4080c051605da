// Frames in the world: Jacobians with base columns and accelerations, compared with finite differences of positions;
// wrenches, compared with the transforms of forces.
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

// Moves with constant accelerations for a short time; terms of the second order cancel in central differences.
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
    // In axes of the foot the same velocity is rotated.
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

// The generated velocities and accelerations of a frame with respect to the base, transformed to the world.
TEST(World, FramesMoveAsTheirPosesDo) {
  std::mt19937_64 engine(54);
  namespace velocities = quadruped::velocities;
  namespace accelerations = quadruped::accelerations;
  const auto velocity_in = [](const State& s) {
    return velocity_in_world(
        s.pose, s.base_velocity, homogeneous::fr_trunk_X_fr_LF_foot(s.q), velocities::fr_trunk_V_fr_LF_foot(s.q, s.qd));
  };
  for (int i = 0; i < kStates; ++i) {
    const State s = random_state(engine);
    Coordinates a;
    for (double& x : a) x = reference::uniform(engine, 1.0);
    const auto foot = [](const State& at) {
      return homogeneous_in_world(at.pose, homogeneous::fr_trunk_X_fr_LF_foot(at.q));
    };
    const State up = moved(s, a, kStep), down = moved(s, a, -kStep);
    const Eigen::Matrix4d rate = (foot(up) - foot(down)) / (2 * kStep);
    const Eigen::Matrix3d spin = rate.topLeftCorner<3, 3>() * foot(s).topLeftCorner<3, 3>().transpose();
    const Vector6 velocity = velocity_in(s);
    EXPECT_LT((velocity.tail<3>() - rate.topRightCorner<3, 1>()).norm(), kDifference);
    EXPECT_LT((velocity.head<3>() - Eigen::Vector3d(spin(2, 1), spin(0, 2), spin(1, 0))).norm(), kDifference);

    const Vector6 acceleration = acceleration_in_world(
        s.pose, s.base_velocity, SpatialAcceleration(a.head<6>()), homogeneous::fr_trunk_X_fr_LF_foot(s.q),
        velocities::fr_trunk_V_fr_LF_foot(s.q, s.qd),
        accelerations::fr_trunk_A_fr_LF_foot(s.q, s.qd, a.tail<quadruped::kDof>()));
    EXPECT_LT((acceleration - (velocity_in(up) - velocity_in(down)) / (2 * kStep)).norm(), kDifference);
    // The same from the Jacobian and the bias that are generated with base columns, in world axes.
    namespace with_base = quadruped::jacobians::with_base;
    const Eigen::Matrix3d R = s.pose.rotation();
    const Vector6 by_jacobian =
        rows_in_axes(R, with_base::fr_trunk_J_fr_LF_foot(s.q)) * a +
        rows_in_axes<double, 1>(R, with_base::fr_trunk_bias_fr_LF_foot(s.q, s.qd, s.base_velocity));
    EXPECT_LT((acceleration - by_jacobian).norm(), kRounding);
  }
}

// Compares the generated functions with those of the runtime, and biases with the rates of the matrices.
TEST(World, GeneratedFunctionsAreThoseOfTheRuntime) {
  std::mt19937_64 engine(56);
  namespace world = quadruped::world;
  namespace in_target = quadruped::world::in_target;
  for (int i = 0; i < kStates; ++i) {
    const State s = random_state(engine);
    Coordinates a;
    for (double& x : a) x = reference::uniform(engine, 1.0);
    const Coordinates v = velocity_of(s);
    const quadruped::JointState qdd = a.tail<quadruped::kDof>();
    const SpatialAcceleration base_acceleration(a.head<6>());
    const Eigen::Matrix4d X = world::X_fr_LF_foot(s.q, s.pose);
    EXPECT_LT((X - foot_in_world(s).homogeneous()).norm(), kRounding);
    EXPECT_LT((world::position_fr_LF_foot(s.q, s.pose) - X.topRightCorner<3, 1>()).norm(), kRounding);

    const auto J = world::J_fr_LF_foot(s.q, s.pose);
    EXPECT_LT((J - rows_in_axes(s.pose.rotation(), foot_jacobian(s))).norm(), kRounding);
    const Vector6 velocity = world::velocity_fr_LF_foot(s.q, s.qd, s.pose, s.base_velocity);
    EXPECT_LT((velocity - J * v).norm(), kRounding);
    const Vector6 bias = world::bias_fr_LF_foot(s.q, s.qd, s.pose, s.base_velocity);
    const Vector6 acceleration =
        world::acceleration_fr_LF_foot(s.q, s.qd, qdd, s.pose, s.base_velocity, base_acceleration);
    EXPECT_LT((acceleration - (J * a + bias)).norm(), kRounding);
    const State up = moved(s, Coordinates::Zero(), kStep), down = moved(s, Coordinates::Zero(), -kStep);
    const Vector6 rate =
        (world::J_fr_LF_foot(up.q, up.pose) - world::J_fr_LF_foot(down.q, down.pose)) * v / (2 * kStep);
    EXPECT_LT((rate - bias).norm(), kDifference);

    const Eigen::Matrix3d to_foot = X.topLeftCorner<3, 3>().transpose();
    const auto turned = [&](const Vector6& of_world) { return rows_in_axes<double, 1>(to_foot, of_world); };
    EXPECT_LT((in_target::J_fr_LF_foot(s.q) - rows_in_axes(to_foot, J)).norm(), kRounding);
    EXPECT_LT((in_target::velocity_fr_LF_foot(s.q, s.qd, s.base_velocity) - turned(velocity)).norm(), kRounding);
    EXPECT_LT((in_target::bias_fr_LF_foot(s.q, s.qd, s.base_velocity) - turned(bias)).norm(), kRounding);
    EXPECT_LT(
        (in_target::acceleration_fr_LF_foot(s.q, s.qd, qdd, s.base_velocity, base_acceleration) - turned(acceleration))
            .norm(),
        kRounding);

    const auto A = world::centroidal_momentum_matrix(s.q, s.pose);
    const Eigen::Matrix<double, 6, 6 + quadruped::kDof> change =
        world::centroidal_momentum_matrix(up.q, up.pose) - world::centroidal_momentum_matrix(down.q, down.pose);
    const Vector6 of_momentum = world::centroidal_momentum_bias(s.q, s.qd, s.pose, s.base_velocity);
    constexpr double kMomentum = 1e-6;  // some tens of N m s, at differences of kStep
    EXPECT_LT((change * v / (2 * kStep) - of_momentum).norm(), kMomentum);
    EXPECT_LT((world::centroidal_momentum(s.q, s.qd, s.pose, s.base_velocity) - A * v).norm(), 100 * kRounding);
    const Eigen::Vector3d com_velocity = world::center_of_mass_velocity(s.q, s.qd, s.pose, s.base_velocity);
    EXPECT_LT((com_velocity - world::center_of_mass_jacobian(s.q, s.pose) * v).norm(), kRounding);
    const Eigen::Vector3d step = world::center_of_mass(up.q, up.pose) - world::center_of_mass(down.q, down.pose);
    EXPECT_LT((com_velocity - step / (2 * kStep)).norm(), kDifference);
  }
}

// Compares the rates of the momentum in world axes and of the centre of mass with central differences.
TEST(World, CentroidalMomentumChangesByMatrixAndBias) {
  constexpr double kMomentum = 1e-6;  // some tens of N m s, at differences of kStep
  std::mt19937_64 engine(55);
  const auto momentum = [](const State& s) -> Vector6 {
    return rows_in_axes(s.pose.rotation(), quadruped::centroidal_momentum_matrix(s.q)) * velocity_of(s);
  };
  const auto com = [](const State& s) { return position_in_world(s.pose, quadruped::center_of_mass(s.q)); };
  for (int i = 0; i < kStates; ++i) {
    const State s = random_state(engine);
    Coordinates a;
    for (double& x : a) x = reference::uniform(engine, 1.0);
    const State up = moved(s, a, kStep), down = moved(s, a, -kStep);
    const Eigen::Matrix3d R = s.pose.rotation();
    const Vector6 rate = rows_in_axes(R, quadruped::centroidal_momentum_matrix(s.q)) * a +
                         rows_in_axes<double, 1>(R, quadruped::centroidal_momentum_bias(s.q, s.qd, s.base_velocity));
    EXPECT_LT((rate - (momentum(up) - momentum(down)) / (2 * kStep)).norm(), kMomentum);
    EXPECT_LT(
        (momentum(s).tail<3>() / quadruped::kTotalMass - (com(up) - com(down)) / (2 * kStep)).norm(), kDifference);
  }
}

// Compares with the generated transform of forces, and with the generalised forces J^T f.
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
