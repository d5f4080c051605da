// Robots with drives: all functions against the reference, and the balance of energy.
#include <gtest/gtest.h>

#include "algorithm/dynamics/dynamics.h"
#include "interpreted_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "volume.h"

namespace robcogen::numeric {
namespace {

using model::KinematicTree;
using reference::Vector;

constexpr int kShards = 4;

KinematicTree robot_of(std::uint64_t seed) {
  RobotOptions options;
  options.max_joints = 20;
  return with_random_drives(random_robot(seed, options), seed);
}

class RandomDrives : public testing::TestWithParam<int> {};

// All choices and passes, passes alone, none.
std::vector<std::string> steps_of(std::uint64_t seed) {
  if (seed % 3 == 0) return all_steps();
  return seed % 3 == 1 ? pass::names() : std::vector<std::string>{};
}

TEST_P(RandomDrives, AgreeWithTheReferenceAndWithThemselves) {
  for (int i = GetParam(); i < robot_count() / 4; i += kShards) {
    const auto seed = static_cast<std::uint64_t>(i);
    const KinematicTree robot = robot_of(seed);
    const reference::Checks checks =
        check_all(InterpretedRobot(robot, random_desired(seed, robot), steps_of(seed)), seed, state_count());
    ASSERT_EQ(checks.failures(), 0) << "seed " << seed << "\n" << checks.failure_report() << describe(robot);
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomDrives, testing::Range(0, kShards));

// ---- Forward dynamics by either method.

TEST(DriveDynamics, MethodsAgree) {
  using algorithm::ForwardDynamicsMethod;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const KinematicTree robot = robot_of(seed);
    const reference::Tables tables = reference_tables(robot);
    const reflection::Robot reflected = tables.robot();
    std::mt19937_64 engine(seed);
    const reference::Sample sample = reference::random_sample(engine, reflected);
    const reference::Case c(reflected, sample, 0);
    const reference::Loads<reference::Real> loads = reference::loads<reference::Real>(sample.gravity);
    const Vector<double> tau = reference::inverse_dynamics(c.robot, c.motion, loads).tau.cast<double>();
    for (const auto method : {ForwardDynamicsMethod::articulated_bodies, ForwardDynamicsMethod::inertia_matrix}) {
      const symbolic::Program program =
          algorithm::forward_dynamics(robot, "f", algorithm::Loads::gravity, {method, {}});
      symbolic::Arrays<double> inputs = {
          {"q", sample.motion.q.values()},
          {"qd", sample.motion.qd.values()},
          {"tau", tau.values()},
          {"gravity", sample.gravity.values()}};
      if (robot.floating_base) inputs["base_velocity"] = sample.motion.base_velocity.values();
      const std::vector<double> qdd = symbolic::interpret(program, inputs).at("qdd");
      const reference::Expected expected = expected_accelerations(c, tau, loads);
      const int n = robot.dof(), first = expected.value.rows() - n;
      for (int j = 0; j < n; ++j)
        EXPECT_NEAR(
            qdd[static_cast<std::size_t>(j)], static_cast<double>(expected.value(first + j)),
            1e-11 * static_cast<double>(expected.terms(first + j)))
            << "seed " << seed << "\n"
            << describe(robot);
    }
  }
}

// ---- Energy.

// The power of the joint forces goes into the energy of the robot and into damping: dE/dt = tau qd - b qd^2.
TEST(DriveDynamics, BalanceEnergy) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const KinematicTree robot = robot_of(seed);
    if (robot.floating_base) continue;
    const InterpretedRobot subject(robot, {}, {});
    const reference::Tables tables = reference_tables(robot);
    std::mt19937_64 engine(seed);
    const reference::Motion<double> m = reference::random_sample(engine, tables.robot()).motion;
    const Vector<double> tau = subject.inverse_dynamics(m, {});
    const Vector<double> qdd = subject.forward_dynamics(m, tau, {});
    double speed = 1, power = 0, terms = 0;
    for (int j = 0; j < robot.dof(); ++j) {
      const double b = model::evaluate(robot.joints[static_cast<std::size_t>(j)].drive.damping);
      speed += std::abs(m.qd(j)) + std::sqrt(std::abs(qdd(j)));
      power += tau(j) * m.qd(j) - b * m.qd(j) * m.qd(j);
      terms += std::abs(tau(j) * m.qd(j)) + b * m.qd(j) * m.qd(j);
    }
    const double step = 1e-2 / speed;
    const auto energy = [&](double steps) {
      reference::Motion<double> there = m;
      there.q += steps * step * m.qd;
      there.qd += steps * step * qdd;
      return subject.kinetic_energy(there) + subject.potential_energy(there.q, {});
    };
    const double change = (8 * (energy(1) - energy(-1)) - (energy(2) - energy(-2))) / (12 * step);
    terms += speed * std::abs(energy(0));
    EXPECT_NEAR(change, power, 1e-8 * terms) << "seed " << seed << "\n" << describe(robot);
  }
}

}  // namespace
}  // namespace robcogen::numeric
