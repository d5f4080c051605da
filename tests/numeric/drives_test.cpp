// Robots with drives: all functions compared with the reference, and the energy balance.
#include <gtest/gtest.h>

#include "algorithm/dynamics/dynamics.h"
#include "interpreted_robot.h"
#include "random_drives.h"
#include "random_robot.h"
#include "volume.h"

namespace robcogen::numeric::drives_test {
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

// All choices and passes, only the passes, or none.
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

// ---- Forward dynamics by both methods.

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

// ---- Rotors.

// Rows are the joints of a robot with rotors, followed by the rotors that they turn: G maps joint velocities to all
// velocities.
reference::Matrix<reference::Real> gears(const RotorBodies& bodies) {
  const int first = bodies.with_rotors.floating_base ? 6 : 0, n = first + bodies.with_rotors.dof();
  reference::Matrix<reference::Real> G(n + static_cast<int>(bodies.driven.size()), n);
  for (int i = 0; i < n; ++i) G(i, i) = 1;
  for (std::size_t r = 0; r < bodies.driven.size(); ++r)
    G(n + static_cast<int>(r), first + bodies.driven[r]) = bodies.ratios[r];
  return G;
}

reference::Motion<reference::Real> motion_of_bodies(
    const reference::Motion<reference::Real>& m,
    const reference::Matrix<reference::Real>& G,
    int first) {
  const auto joints = [&](const Vector<reference::Real>& v) {
    return G.block(first, first, G.rows() - first, v.rows()) * v;
  };
  return {joints(m.q), joints(m.qd), joints(m.qdd), m.base_velocity, m.base_acceleration};
}

// A rotor acts like a body of its own that turns with its joint: forces are G' times those of the bodies.
TEST(Rotors, AreAsBodiesThatTurnWithTheirJoints) {
  using reference::Real;
  RobotOptions options;
  options.max_joints = 12;
  options.odd_documents = false;
  int rotors = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const RotorBodies bodies = with_rotor_bodies(random_robot(seed, options), seed);
    rotors += static_cast<int>(bodies.driven.size());
    const InterpretedRobot subject(bodies.with_rotors, {}, steps_of(seed));
    const reference::Tables tables = reference_tables(bodies.with_rotors),
                            full_tables = reference_tables(bodies.with_bodies);
    const reflection::Robot robot = tables.robot(), full = full_tables.robot();
    std::mt19937_64 engine(seed);
    const reference::Sample sample = reference::random_sample(engine, robot);
    const int first = robot.floating_base ? 6 : 0;
    const reference::Matrix<Real> G = gears(bodies);
    const reference::Motion<Real> m = motion_of_bodies(reference::cast<Real>(sample.motion), G, first);
    const auto reduced = [&](const reference::Forces<Real>& f) {
      return transpose(G) * reference::coordinates(robot.floating_base, f.base_wrench, f.tau);
    };
    const reference::Case c(robot, sample, 0);
    const reference::Loads<Real> loads = reference::loads<Real>(sample.gravity);
    const reference::Arguments gravity{&sample.gravity, nullptr};
    reference::Checks checks;
    const auto compare = [&](const char* name, const Vector<double>& found, const Vector<Real>& expected) {
      const Vector<Real> terms = expected_forces(c, sample.motion, loads).terms;
      checks.record(name, reference::kForce, reference::error_of(c, found, {expected, terms}), 0);
    };
    compare(
        "inverse dynamics", subject.inverse_dynamics_fully_actuated(sample.motion, gravity),
        reduced(reference::inverse_dynamics_fully_actuated(full, m, loads)));
    compare(
        "bias forces", subject.bias_forces(sample.motion, gravity), reduced(reference::bias_forces(full, m, loads)));
    compare("Coriolis forces", subject.coriolis_forces(sample.motion), reduced(reference::coriolis_forces(full, m)));
    const reference::Matrix<Real> H = transpose(G) * (reference::joint_space_inertia(full, m.q) * G);
    checks.record(
        "H", reference::kInertia,
        reference::relative_error(
            subject.joint_space_inertia(sample.motion.q).cast<Real>(), H, reference::inertia_magnitude(c)),
        0);
    const Real energy = reference::kinetic_energy(full, m);
    checks.record(
        "kinetic energy", reference::kEnergy,
        std::abs(static_cast<Real>(subject.kinetic_energy(sample.motion)) - energy) / std::abs(energy), 0);
    ASSERT_EQ(checks.failures(), 0) << "seed " << seed << "\n"
                                    << checks.failure_report() << describe(bodies.with_rotors);
  }
  EXPECT_GT(rotors, 1000);
}

// ---- Energy.

// The power of the joint forces goes into the energy of the robot and into the passive forces; where these are damping
// only, dE/dt = tau qd - b qd^2.
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
    const Vector<double> passive = reference::passive_forces(tables.robot(), m);
    double speed = 1, power = 0, terms = 0;
    for (int j = 0; j < robot.dof(); ++j) {
      speed += std::abs(m.qd(j)) + std::sqrt(std::abs(qdd(j)));
      power += (tau(j) - passive(j)) * m.qd(j);
      terms += (std::abs(tau(j)) + std::abs(passive(j))) * std::abs(m.qd(j));
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
}  // namespace robcogen::numeric::drives_test
