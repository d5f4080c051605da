// Work and momentum balances: what energy and momentum do in time against the forces that the dynamics report.
#include <gtest/gtest.h>

#include "sample_robots.h"

namespace robcogen::reference {
namespace {

using Real = long double;

// Central differences with step 1e-5 in long double: truncation 1e-10 times third derivatives of order 1e3.
constexpr Real kStep = 1e-5L;
constexpr double kDifference = 1e-6;
constexpr double kRounding = 1e-12;

// The state at time t of a motion with constant accelerations; the twist's components grow by the spatial acceleration.
Motion<Real> at_time(const Motion<double>& motion, Real t) {
  Motion<Real> moved;
  moved.qdd = motion.qdd.cast<Real>();
  moved.qd = motion.qd.cast<Real>() + t * moved.qdd;
  moved.q = motion.q.cast<Real>() + t * motion.qd.cast<Real>() + t * t / 2 * moved.qdd;
  moved.base_acceleration = motion.base_acceleration.cast<Real>();
  moved.base_velocity = motion.base_velocity.cast<Real>() + t * moved.base_acceleration;
  return moved;
}

class ReferenceEnergy : public testing::TestWithParam<bool> {
 protected:
  Tables tables_ = crooked_tree(GetParam());
  Robot robot_ = tables_.robot();
  std::mt19937_64 engine_{20};
  Motion<double> motion_ = random_motion(engine_, robot_);
};

TEST_P(ReferenceEnergy, KineticEnergyIsTheQuadraticFormOfTheInertiaMatrix) {
  VectorX<double> velocity = motion_.qd;
  if (robot_.floating_base) {
    velocity.resize(6 + motion_.qd.size());
    velocity << motion_.base_velocity, motion_.qd;
  }
  const double quadratic = velocity.dot(joint_space_inertia(robot_, motion_.q) * velocity) / 2;
  EXPECT_NEAR(kinetic_energy(robot_, motion_) / quadratic, 1, kRounding);
}

TEST_P(ReferenceEnergy, PowerIsTheRateOfKineticEnergy) {
  const Real rate =
      (kinetic_energy(robot_, at_time(motion_, kStep)) - kinetic_energy(robot_, at_time(motion_, -kStep))) /
      (2 * kStep);
  const Forces<double> forces = inverse_dynamics_fully_actuated(robot_, motion_, {Vector3<double>::Zero(), {}});
  const double power = forces.tau.dot(motion_.qd) + forces.base_wrench.dot(motion_.base_velocity);
  EXPECT_NEAR(static_cast<double>(rate), power, kDifference * std::abs(power));
}

TEST_P(ReferenceEnergy, GravityForcesAreTheGradientOfPotentialEnergy) {
  const Vector3<double> gravity(1.5, -2.5, -9);
  const VectorX<double> tau = gravity_forces(robot_, motion_.q, gravity).tau;
  for (int j = 0; j < robot_.joints.size; ++j) {
    VectorX<Real> ahead = motion_.q.cast<Real>(), behind = ahead;
    ahead(j) += kStep;
    behind(j) -= kStep;
    const Vector3<Real> g = gravity.cast<Real>();
    const Real slope = (potential_energy(robot_, ahead, g) - potential_energy(robot_, behind, g)) / (2 * kStep);
    EXPECT_NEAR(static_cast<double>(slope), tau(j), kDifference * tau.norm());
  }
}

// d/dt of the momentum about a point at rest = the base wrench + the weight.
TEST_P(ReferenceEnergy, BaseWrenchAndWeightAreTheRateOfMomentum) {
  const Vector3<double> gravity(1.5, -2.5, -9);
  const Vector6<double> components =
      ((momentum(robot_, at_time(motion_, kStep)) - momentum(robot_, at_time(motion_, -kStep))) / (2 * kStep))
          .cast<double>();
  // The components are taken in the moving base frame.
  const Vector6<double> h = momentum(robot_, motion_);
  const Vector3<double> w = motion_.base_velocity.head<3>(), v = motion_.base_velocity.tail<3>();
  Vector6<double> rate = components;
  rate.head<3>() += w.cross(h.head<3>()) + v.cross(h.tail<3>());
  rate.tail<3>() += w.cross(h.tail<3>());

  const Vector6<double> wrench = inverse_dynamics_fully_actuated(robot_, motion_, {gravity, {}}).base_wrench;
  const Vector6<double> weight = -gravity_forces(robot_, motion_.q, gravity).base_wrench;
  EXPECT_LT((wrench + weight - rate).norm(), kDifference * rate.norm());
}

INSTANTIATE_TEST_SUITE_P(Bases, ReferenceEnergy, testing::Bool(), [](const auto& instance) {
  return std::string(instance.param ? "Floating" : "Fixed");
});

TEST(ReferenceEnergyClosedForm, Pendulum) {
  const double m = 2.5, l = 0.6, I = 0.08;
  const Tables tables = pendulum(m, l, I);
  Motion<double> motion = at_rest<double>(VectorX<double>::Constant(1, 0.7));
  motion.qd(0) = 3;
  EXPECT_NEAR(kinetic_energy(tables.robot(), motion), (I + m * l * l) * 9 / 2, kRounding);
  EXPECT_NEAR(potential_energy<double>(tables.robot(), motion.q, {0, 0, -9.81}), -m * 9.81 * l * std::cos(0.7), 1e-11);
  const Vector6<double> h = momentum(tables.robot(), motion);
  EXPECT_NEAR(h(1), -(I + m * l * l) * 3, kRounding);  // the joint turns about -y
  EXPECT_NEAR(h(3), m * l * 3 * std::cos(0.7), kRounding);
  EXPECT_NEAR(h(5), m * l * 3 * std::sin(0.7), kRounding);
}

}  // namespace
}  // namespace robcogen::reference
