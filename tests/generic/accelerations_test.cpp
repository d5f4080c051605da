// Results that steps of integration take.
#include "robcogen/generic/accelerations.h"

#include <gtest/gtest.h>

#include "robcogen/generic/all_joints.h"
#include "tiny_robots.h"

namespace robcogen::test::accelerations_test {
namespace {

static_assert(AccelerationsOf<Eigen::Vector2d, Fixed>);
static_assert(AccelerationsOf<Eigen::VectorXd, Fixed>);
static_assert(AccelerationsOf<decltype(2.0 * Eigen::Vector2d()), Fixed>);
static_assert(AccelerationsOf<ConstrainedFixed, Fixed>);
static_assert(!AccelerationsOf<Eigen::Vector3d, Fixed>);
static_assert(!AccelerationsOf<double, Fixed>);
static_assert(!AccelerationsOf<ImpactFixed, Fixed>);
static_assert(!AccelerationsOf<LoopConstrained, Fixed>);

static_assert(AccelerationsOf<Floating::GeneralizedAcceleration, Floating>);
static_assert(AccelerationsOf<ConstrainedFloating, Floating>);
static_assert(!AccelerationsOf<Eigen::Vector2d, Floating>);
static_assert(!AccelerationsOf<ConstrainedFixed, Floating>);
static_assert(!AccelerationsOf<Floating::InverseDynamics, Floating>);
static_assert(!AccelerationsOf<ImpactFloating, Floating>);

constexpr double kStep = 0.125;
const Eigen::Vector2d kQdd(0.5, -0.25);
const SpatialAcceleration kOfBase(Eigen::Vector3d(1, -2, 0.5), Eigen::Vector3d(0.25, 3, -1));

State<Floating> floating_state() {
  State<Floating> state;
  state.q << 0.25, 1.0;
  state.qd << -0.5, 2.0;
  state.pose = BasePose::from_rpy(0.1, -0.4, 1.2, Eigen::Vector3d(1, 2, 3));
  state.base_velocity = Twist(Eigen::Vector3d(0.3, 0.2, -0.7), Eigen::Vector3d(1, -1, 0.5));
  return state;
}

template <class State>
void expect_same(const State& a, const State& b) {
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.qd, b.qd);
  if constexpr (requires { a.pose; }) {
    EXPECT_EQ(a.pose.homogeneous(), b.pose.homogeneous());
    EXPECT_EQ(a.base_velocity, b.base_velocity);
  }
}

TEST(Accelerations, OfAFixedBaseAreAVectorOrAMember) {
  State<Fixed> state;
  state.qd << -0.5, 2.0;
  State<Fixed> expected;
  expected.qd << -0.4375, 1.96875;
  expected.q << -0.0546875, 0.24609375;
  expect_same(integrate(state, kQdd, kStep), expected);
  expect_same(integrate(state, {0.5, -0.25}, kStep), expected);
  expect_same(integrate(state, 0.5 * (2 * kQdd), kStep), expected);
  expect_same(integrate(state, Eigen::VectorXd(kQdd), kStep), expected);
  expect_same(integrate(state, ConstrainedFixed{kQdd, {}}, kStep), expected);
  expect_same(semi_implicit_euler_step(state, kStep, [](const auto&) { return ConstrainedFixed{kQdd, {}}; }), expected);
}

TEST(Accelerations, OfAFloatingBaseAreMembers) {
  const State<Floating> state = floating_state();
  const Floating::GeneralizedAcceleration plain{kQdd, kOfBase};
  const ConstrainedFloating constrained{kQdd, kOfBase, {}};
  const State<Floating> expected = integrate(state, plain, kStep);
  EXPECT_EQ(expected.base_velocity, state.base_velocity + kStep * Twist(kOfBase.vector()));
  expect_same(integrate(state, {kQdd, kOfBase}, kStep), expected);
  expect_same(integrate(state, constrained, kStep), expected);
  expect_same(semi_implicit_euler_step(state, kStep, [&](const auto&) { return constrained; }), expected);
  expect_same(
      runge_kutta_step(state, kStep, [&](const auto&) { return constrained; }),
      runge_kutta_step(state, kStep, [&](const auto&) { return plain; }));
}

TEST(Accelerations, ImpactsChangeVelocitiesOnly) {
  State<Floating> expected = floating_state();
  const ImpactFloating impact{{3, 4}, Twist(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)), {}};
  const State<Floating> after = after_impact(expected, impact);
  expected.qd << 3, 4;
  expected.base_velocity = impact.base_velocity_after;
  expect_same(after, expected);
  EXPECT_EQ(after_impact(State<Fixed>(), ImpactFixed{{3, 4}, {}}).qd, Eigen::Vector2d(3, 4));
}

TEST(Accelerations, OfAllJointsMoveAllJoints) {
  const LoopConstrained result{{1, 2, 3}, kOfBase, {}};
  const auto state = all_joints(Floating(), floating_state());
  EXPECT_EQ(state.positions, Eigen::Vector3d(0.25, 1.0, 0.5));
  const auto next = integrate(state, result, kStep);
  const Eigen::Vector3d velocities(-0.375, 2.25, 1.375);
  EXPECT_EQ(next.velocities, velocities);
  EXPECT_EQ(next.positions, state.positions + kStep * velocities);
  const State<Floating> base = integrate(floating_state(), {kQdd, kOfBase}, kStep);
  EXPECT_EQ(next.pose.homogeneous(), base.pose.homogeneous());
  EXPECT_EQ(next.base_velocity, base.base_velocity);
  const auto fixed = integrate(all_joints(Fixed(), State<Fixed>()), result, kStep);
  EXPECT_EQ(fixed.positions, Eigen::Vector3d(1, 2, 3) * kStep * kStep);
}

}  // namespace
}  // namespace robcogen::test::accelerations_test
