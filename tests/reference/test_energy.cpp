// Work and momentum balances: the changes of energy and momentum in time, compared with the forces of the dynamics.
#include <gtest/gtest.h>

#include "sample_robots.h"

namespace robcogen::reference::energy_test {
namespace {

using Real = long double;

// Central differences with step 1e-5 in long double: truncation 1e-10 times third derivatives of order 1e3.
constexpr Real kStep = 1e-5L;
constexpr double kDifference = 1e-6;
constexpr double kRounding = 1e-12;

// The state at time t of a motion with constant accelerations; the twist's components grow by the spatial acceleration.
Motion<Real> at_time(const Motion<double>& start, Real t) {
  Motion<Real> moved = cast<Real>(start);
  moved.q += t * moved.qd + t * t / 2 * moved.qdd;
  moved.qd += t * moved.qdd;
  moved.base_velocity += t * moved.base_acceleration;
  return moved;
}

class ReferenceEnergy : public testing::TestWithParam<bool> {
 protected:
  Tables tables_ = crooked_tree(GetParam());
  Robot robot_ = tables_.robot();
  std::mt19937_64 engine_{20};
  Motion<double> motion_ = random_motion(engine_, robot_);
  Vector<double> gravity_{1.5, -2.5, -9};
};

TEST_P(ReferenceEnergy, KineticEnergyIsTheQuadraticFormOfTheInertiaMatrix) {
  const Vector<double> velocity = robot_.floating_base ? stacked(motion_.base_velocity, motion_.qd) : motion_.qd;
  const double quadratic = dot(velocity, joint_space_inertia(robot_, motion_.q) * velocity) / 2;
  EXPECT_NEAR(kinetic_energy(robot_, motion_) / quadratic, 1, kRounding);
}

TEST_P(ReferenceEnergy, PowerIsTheRateOfKineticEnergy) {
  const Real after = kinetic_energy(robot_, at_time(motion_, kStep));
  const Real before = kinetic_energy(robot_, at_time(motion_, -kStep));
  const Forces<double> forces = inverse_dynamics_fully_actuated(robot_, motion_, {Vector<double>(3), {}});
  const double power = dot(forces.tau, motion_.qd) + dot(forces.base_wrench, motion_.base_velocity);
  EXPECT_NEAR(static_cast<double>((after - before) / (2 * kStep)), power, kDifference * std::abs(power));
}

TEST_P(ReferenceEnergy, GravityForcesAreTheGradientOfPotentialEnergy) {
  const Vector<double> tau = gravity_forces(robot_, motion_.q, gravity_).tau;
  for (int j = 0; j < robot_.joints.size; ++j) {
    Vector<Real> ahead = motion_.q.cast<Real>(), behind = ahead;
    ahead(j) += kStep;
    behind(j) -= kStep;
    const Vector<Real> g = gravity_.cast<Real>();
    const Real slope = (potential_energy(robot_, ahead, g) - potential_energy(robot_, behind, g)) / (2 * kStep);
    EXPECT_NEAR(static_cast<double>(slope), tau(j), kDifference * largest(tau));
  }
}

// d/dt of the momentum about a point at rest is the base wrench plus the weight.
TEST_P(ReferenceEnergy, BaseWrenchAndWeightAreTheRateOfMomentum) {
  const Vector<Real> change = momentum(robot_, at_time(motion_, kStep)) - momentum(robot_, at_time(motion_, -kStep));
  // The components are taken in the moving base frame.
  const Vector<double> h = momentum(robot_, motion_);
  const Vector<double> w = motion_.base_velocity.head(3), v = motion_.base_velocity.tail(3);
  const Vector<double> rate = (1 / (2 * kStep) * change).cast<double>() +
                              stacked(cross(w, h.head(3)) + cross(v, h.tail(3)), cross(w, h.tail(3)));

  const Vector<double> wrench = inverse_dynamics_fully_actuated(robot_, motion_, {gravity_, {}}).base_wrench;
  const Vector<double> weight = -gravity_forces(robot_, motion_.q, gravity_).base_wrench;
  EXPECT_LT(largest(wrench + weight - rate), kDifference * largest(rate));
}

INSTANTIATE_TEST_SUITE_P(Bases, ReferenceEnergy, testing::Bool(), [](const auto& instance) {
  return std::string(instance.param ? "Floating" : "Fixed");
});

TEST(ReferenceEnergyClosedForm, Pendulum) {
  const double m = 2.5, l = 0.6, I = 0.08;
  const Tables tables = pendulum(m, l, I);
  const Motion<double> motion{{0.7}, {3.0}, {0.0}};
  EXPECT_NEAR(kinetic_energy(tables.robot(), motion), (I + m * l * l) * 9 / 2, kRounding);
  EXPECT_NEAR(
      potential_energy<double>(tables.robot(), motion.q, {0, 0, -9.81}), -m * 9.81 * l * std::cos(0.7), 10 * kRounding);
  const Vector<double> h = momentum(tables.robot(), motion);
  EXPECT_NEAR(h(1), -(I + m * l * l) * 3, kRounding);  // the joint turns about -y
  EXPECT_NEAR(h(3), m * l * 3 * std::cos(0.7), kRounding);
  EXPECT_NEAR(h(5), m * l * 3 * std::sin(0.7), kRounding);
}

}  // namespace
}  // namespace robcogen::reference::energy_test
