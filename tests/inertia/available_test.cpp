// The functions that robots with singular inertia matrices have, and their results.
#include <gtest/gtest.h>
#include <pointer/pointer.h>
#include <pointers/batch.h>
#include <pointers/pointers.h>
#include <robcogen/concepts.h>
#include <satellite/satellite.h>
#include <stylus/stylus.h>

#include <cmath>

namespace robcogen {
namespace {

static_assert(!HasInverseDynamics<pointer::Robot>);
static_assert(!HasJointSpaceInertia<pointer::Robot>);
static_assert(!HasForwardDynamics<pointer::Robot>);

static_assert(HasInverseDynamics<stylus::Robot>);
static_assert(HasJointSpaceInertia<stylus::Robot>);
static_assert(!HasForwardDynamics<stylus::Robot>);
static_assert(!HasJointSpaceInertiaFactor<stylus::Robot>);

static_assert(HasJointSpaceInertia<satellite::Robot>);
static_assert(!HasForwardDynamics<satellite::Robot>);
static_assert(!HasJointSpaceInertiaFactor<satellite::Robot>);
static_assert(!HasInverseDynamics<satellite::Robot>);  // with a free base

TEST(Availability, KinematicsAloneHasTransformsAndJacobians) {
  const pointer::JointState q(0.3, -0.8);
  const Eigen::Matrix4d X = pointer::transforms::homogeneous::fr_base_X_tip(q);
  // Two bars in the plane y = 0, starting at (0, 0, 0.2).
  EXPECT_NEAR(X(0, 3), 0.4 * std::cos(0.3) + 0.3 * std::cos(-0.5), 1e-15);
  EXPECT_NEAR(X(2, 3), 0.2 + 0.4 * std::sin(0.3) + 0.3 * std::sin(-0.5), 1e-15);
  const auto J = pointer::jacobians::fr_base_J_tip(q);
  EXPECT_NEAR(J(3, 1), -0.3 * std::sin(-0.5), 1e-15);
}

TEST(Availability, InverseDynamicsOfAWeightlessTip) {
  const stylus::JointState q(0.3, 0.7), qd(0.5, 2.0), qdd(1.5, -3.0);
  const stylus::JointState tau = stylus::inverse_dynamics(q, qd, qdd);
  EXPECT_EQ(tau[1], 0.0);
  // A pendulum: inertia about the axis, and gravity on (0.2, 0.01) rotated by q.
  const double moment = 1.3 * 9.81 * (0.2 * std::cos(0.3) - 0.01 * std::sin(0.3));
  EXPECT_NEAR(tau[0], 0.09 * 1.5 + moment, 1e-14);
  const stylus::InertiaMatrix H = stylus::joint_space_inertia(q);
  EXPECT_EQ(H(1, 1), 0.0);
  EXPECT_NEAR(H(0, 0), 0.09, 1e-15);
}

TEST(Availability, AFloatingRodHasItsInertiaMatrixAndItsWrench) {
  const satellite::JointState q(0.4), still(0.0);
  const satellite::InertiaMatrix H = satellite::joint_space_inertia(q);
  EXPECT_EQ(H(0, 0), 0.0);
  EXPECT_EQ(H(1, 1), 0.5);
  EXPECT_EQ(H(3, 3), 2.0);
  const auto result =
      satellite::inverse_dynamics_fully_actuated(q, still, still, Twist(), SpatialAcceleration(), Gravity(0, 0, -9.81));
  EXPECT_NEAR(result.base_wrench.linear()[2], 2 * 9.81, 1e-14);
}

}  // namespace
}  // namespace robcogen
