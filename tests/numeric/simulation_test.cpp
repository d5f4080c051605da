// P3 over time: ten seconds of free motion, by the forward dynamics of the programs, conserve energy and momentum.
#include <gtest/gtest.h>

#include "interpreted_robot.h"
#include "random_robot.h"

namespace robcogen::numeric::simulation_test {
namespace {

using model::KinematicTree;
using reference::Matrix;
using reference::Motion;
using reference::Vector;

// Fourth-order Runge-Kutta: truncation is a few step^4 = 1e-12 for motions of a few rad/s, more for fast small links.
constexpr double kStep = 1e-3;  // s
constexpr int kSteps = 10000;
constexpr double kDrift = 1e-8;  // relative to the energy that is exchanged

const Vector<double> kGravity{0, 0, -9.81};  // world axes

// The pose of the base in the world, whose frame is the base frame if the base is fixed; and the motion in base
// coordinates.
struct State {
  Matrix<double> base = Matrix<double>::identity(4);
  Vector<double> q, qd;
  Vector<double> base_velocity = Vector<double>(6);
};

State operator+(const State& a, const State& b) {
  return {a.base + b.base, a.q + b.q, a.qd + b.qd, a.base_velocity + b.base_velocity};
}
State operator*(double s, const State& a) {
  return {s * a.base, s * a.q, s * a.qd, s * a.base_velocity};
}

Vector<double> gravity_in_base(const State& s) {
  return transpose(reference::rotation_of(s.base)) * kGravity;
}

Motion<double> motion_of(const State& s) {
  Motion<double> m = reference::at_rest(s.q);
  m.qd = s.qd;
  m.base_velocity = s.base_velocity;
  return m;
}

// There are no joint forces; only gravity acts.
State rate(const InterpretedRobot& robot, bool floating, const State& s) {
  const Vector<double> gravity = gravity_in_base(s);
  const Vector<double> accelerations =
      robot.forward_dynamics(motion_of(s), Vector<double>(s.q.rows()), {&gravity, nullptr});
  State r{Matrix<double>(4, 4), s.qd, accelerations.tail(s.q.rows())};
  if (!floating) return r;
  const Matrix<double> R = reference::rotation_of(s.base);
  r.base.set_block(0, 0, R * reference::skew(s.base_velocity.head(3)));
  r.base.set_block(0, 3, R * s.base_velocity.tail(3));
  r.base_velocity = accelerations.head(6);
  return r;
}

State step(const InterpretedRobot& robot, bool floating, const State& s) {
  const State a = rate(robot, floating, s);
  const State b = rate(robot, floating, s + kStep / 2 * a);
  const State c = rate(robot, floating, s + kStep / 2 * b);
  const State d = rate(robot, floating, s + kStep * c);
  return s + kStep / 6 * (a + 2.0 * b + 2.0 * c + d);
}

// A few heavy links with long levers, so that the motion is smooth at the scale of a step.
KinematicTree slow_robot(std::uint64_t seed, bool floating) {
  KinematicTree robot = random_robot(seed, {.min_joints = 3, .max_joints = 3, .odd_documents = false});
  robot.floating_base = floating;
  for (model::Joint& joint : robot.joints) joint.type = model::JointType::revolute;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    model::Inertia inertia;
    inertia.mass = model::Quantity(2.0);
    inertia.com = {model::Quantity(0.1), model::Quantity(-0.05), model::Quantity(0.02)};
    inertia.ixx = model::Quantity(0.7);
    inertia.iyy = model::Quantity(0.8);
    inertia.izz = model::Quantity(0.9);
    inertia.ixy = model::Quantity(-0.03);
    inertia.iyz = model::Quantity(0.02);
    robot.links[i].inertia = inertia;
  }
  return robot;
}

State start(const KinematicTree& robot) {
  State s;
  s.q = Vector<double>(robot.dof());
  s.qd = Vector<double>(robot.dof());
  for (int j = 0; j < robot.dof(); ++j) {
    s.q(j) = 0.5 - 0.4 * j;
    s.qd(j) = 1.0 - 0.7 * j;
  }
  if (robot.floating_base) s.base_velocity = {0.8, -0.5, 0.3, 0.2, -0.4, 1.0};
  return s;
}

double energy(const reflection::Robot& tables, const State& s) {
  // The potential energy about the base origin does not include the height of that origin.
  double mass = 0;
  for (const reflection::Link& link : tables.links) mass += link.mass;
  return reference::kinetic_energy(tables, motion_of(s)) +
         reference::potential_energy(tables, s.q, gravity_in_base(s)) -
         mass * dot(kGravity, reference::origin_of(s.base));
}

TEST(Simulation, EnergyOfASwingingRobotIsKept) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const InterpretedRobot robot(slow_robot(seed, false), {});
    const reflection::Robot tables = robot.tables();
    State s = start(slow_robot(seed, false));
    const double before = energy(tables, s);
    double most_kinetic = 0;
    for (int k = 0; k < kSteps; ++k) {
      s = step(robot, false, s);
      if (k % 100 == 0) most_kinetic = std::max(most_kinetic, reference::kinetic_energy(tables, motion_of(s)));
    }
    EXPECT_GT(most_kinetic, 0.1) << "seed " << seed;
    EXPECT_LT(std::abs(energy(tables, s) - before), kDrift * most_kinetic) << "seed " << seed;
  }
}

TEST(Simulation, EnergyAndMomentumOfAFallingRobotAreKept) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const InterpretedRobot robot(slow_robot(seed, true), {});
    const reflection::Robot tables = robot.tables();
    State s = start(slow_robot(seed, true));
    const auto world_momentum = [&] {
      return reference::force_form(s.base) * reference::momentum(tables, motion_of(s));
    };
    const auto center_of_mass = [&] {
      double mass = 0;
      Vector<double> moment(3);
      const auto poses = reference::link_poses(tables, s.q);
      for (int i = 0; i < tables.links.size; ++i) {
        const Matrix<double> pose = s.base * poses[static_cast<std::size_t>(i)];
        const Vector<double> com = reference::center_of_mass<double>(tables.links[i]);
        mass += tables.links[i].mass;
        moment += tables.links[i].mass * (reference::rotation_of(pose) * com + reference::origin_of(pose));
      }
      return std::pair(mass, 1 / mass * moment);
    };
    const double energy_before = energy(tables, s);
    const Vector<double> before = world_momentum();
    const auto [mass, com_before] = center_of_mass();
    for (int k = 0; k < kSteps; ++k) s = step(robot, true, s);
    const Vector<double> after = world_momentum();
    const Vector<double> com_after = center_of_mass().second;

    const double duration = kStep * kSteps;
    const double falling = mass * 9.81 * duration;  // the momentum that gravity gives
    EXPECT_LT(largest(after.tail(3) - before.tail(3) - mass * duration * kGravity), kDrift * falling)
        << "seed " << seed;
    // No moment acts about the centre of mass.
    const Vector<double> spin_before = before.head(3) - cross(com_before, before.tail(3));
    const Vector<double> spin_after = after.head(3) - cross(com_after, after.tail(3));
    EXPECT_GT(largest(spin_before), 0.1) << "seed " << seed;
    EXPECT_LT(largest(spin_after - spin_before), kDrift * largest(com_after) * falling) << "seed " << seed;
    const Vector<double> fallen =
        com_before + 1 / mass * duration * before.tail(3) + duration * duration / 2 * kGravity;
    EXPECT_LT(largest(com_after - fallen), kDrift * largest(fallen)) << "seed " << seed;
    EXPECT_LT(std::abs(energy(tables, s) - energy_before), kDrift * falling * 9.81 * duration) << "seed " << seed;
  }
}

}  // namespace
}  // namespace robcogen::numeric::simulation_test
