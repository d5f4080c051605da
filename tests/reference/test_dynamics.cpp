// The reference's dynamics, compared with closed forms of small robots, and with itself where one function inverts
// another.
#include <gtest/gtest.h>

#include "sample_robots.h"

namespace robcogen::reference::dynamics_test {
namespace {

// Rounding of a few dozen operations, relative to forces of order 100.
constexpr double kRounding = 1e-11;
constexpr double kG = 9.81;

double distance(const Matrix<double>& a, const Matrix<double>& b) {
  return largest(a - b);
}

TEST(ReferenceDynamics, Pendulum) {
  const double m = 2.5, l = 0.6, I = 0.08;
  const Tables tables = pendulum(m, l, I);
  for (const double q : {0.0, 0.4, 1.5, -2.8}) {
    const Motion<double> motion{{q}, {1.7}, {-3.1}};
    const double gravity = m * kG * l * std::sin(q);
    EXPECT_NEAR(inverse_dynamics(tables.robot(), motion, {}).tau(0), (I + m * l * l) * -3.1 + gravity, kRounding);
    EXPECT_NEAR(joint_space_inertia(tables.robot(), motion.q)(0, 0), I + m * l * l, kRounding);
    EXPECT_NEAR(gravity_forces(tables.robot(), motion.q, {0, 0, -kG}).tau(0), gravity, kRounding);
    EXPECT_NEAR(gravity_forces(tables.robot(), motion.q, {2, 0, 0}).tau(0), -m * l * 2 * std::cos(q), kRounding);
    EXPECT_NEAR(coriolis_forces(tables.robot(), motion).tau(0), 0, kRounding);
    EXPECT_NEAR(
        forward_dynamics(tables.robot(), motion, {5.0}, {}).qdd(0), (5.0 - gravity) / (I + m * l * l), kRounding);
  }
}

// When the pendulum swings through the bottom, its support carries the weight and the centripetal force.
TEST(ReferenceDynamics, PendulumSupport) {
  const Tables tables = pendulum(2, 0.5, 0.1);
  const Vector<double> wrench = bias_forces(tables.robot(), Motion<double>{{0.0}, {3.0}, {0.0}}, {}).base_wrench;
  EXPECT_LT(distance(wrench, {0, 0, 0, 0, 0, 2 * kG + 2 * 0.5 * 9.0}), kRounding);
}

TEST(ReferenceDynamics, DoublePendulum) {
  const double m1 = 1.2, l1 = 0.7, m2 = 0.8, l2 = 0.45;
  const Tables tables = double_pendulum(m1, l1, m2, l2);
  std::mt19937_64 engine(5);
  for (int sample = 0; sample < 10; ++sample) {
    const Motion<double> motion = random_motion(engine, tables.robot());
    const double q1 = motion.q(0), q2 = motion.q(1), w1 = motion.qd(0), w2 = motion.qd(1);
    const double coupling = m2 * l1 * l2;
    Matrix<double> H(2, 2);
    H(0, 0) = (m1 + m2) * l1 * l1 + m2 * l2 * l2 + 2 * coupling * std::cos(q2);
    H(0, 1) = H(1, 0) = m2 * l2 * l2 + coupling * std::cos(q2);
    H(1, 1) = m2 * l2 * l2;
    const Vector<double> C{-coupling * std::sin(q2) * (2 * w1 * w2 + w2 * w2), coupling * std::sin(q2) * w1 * w1};
    const double lower = m2 * kG * l2 * std::sin(q1 + q2);
    const Vector<double> G{(m1 + m2) * kG * l1 * std::sin(q1) + lower, lower};
    EXPECT_LT(distance(joint_space_inertia(tables.robot(), motion.q), H), kRounding);
    EXPECT_LT(distance(coriolis_forces(tables.robot(), motion).tau, C), kRounding);
    EXPECT_LT(distance(gravity_forces(tables.robot(), motion.q, {0, 0, -kG}).tau, G), kRounding);
    EXPECT_LT(distance(inverse_dynamics(tables.robot(), motion, {}).tau, H * motion.qdd + C + G), kRounding);
  }
}

TEST(ReferenceDynamics, CartPole) {
  const double M = 3, m = 0.6, l = 0.8;
  const Tables tables = cart_pole(M, m, l);
  std::mt19937_64 engine(6);
  for (int sample = 0; sample < 10; ++sample) {
    const Motion<double> motion = random_motion(engine, tables.robot());
    const double c = std::cos(motion.q(1)), s = std::sin(motion.q(1)), w = motion.qd(1);
    const double a = motion.qdd(0), alpha = motion.qdd(1);
    const Vector<double> expected{
        (M + m) * a + m * l * c * alpha - m * l * s * w * w, m * l * c * a + m * l * l * alpha + m * kG * l * s};
    EXPECT_LT(distance(inverse_dynamics(tables.robot(), motion, {}).tau, expected), kRounding);
  }
}

TEST(ReferenceDynamics, FreeBodyObeysEulersEquations) {
  const Triple I = {0.3, 0.5, 0.7};
  const Tables tables = free_body(4, {}, I);
  Motion<double> motion = at_rest(Vector<double>());
  motion.base_velocity = {1.0, -2.0, 0.5, 0.3, 0.2, -0.1};
  const Vector<double> w = motion.base_velocity.head(3), v = motion.base_velocity.tail(3);
  const Vector<double> gravity{1, 2, -9};
  const Vector<double> a = forward_dynamics(tables.robot(), motion, {}, {gravity, {}}).base_acceleration;
  EXPECT_NEAR(a(0), (I[1] - I[2]) * w(1) * w(2) / I[0], kRounding);
  EXPECT_NEAR(a(1), (I[2] - I[0]) * w(2) * w(0) / I[1], kRounding);
  EXPECT_NEAR(a(2), (I[0] - I[1]) * w(0) * w(1) / I[2], kRounding);
  // The origin is the centre of mass and falls: its classical acceleration is gravity.
  EXPECT_LT(distance(a.tail(3) + cross(w, v), gravity), kRounding);
}

TEST(ReferenceDynamics, FreeBodyWithOffsetCentreOfMass) {
  const double m = 4;
  const Vector<double> c{0.1, -0.2, 0.3}, g{0, 0, -kG};
  const Vector<double> I{0.3, 0.5, 0.7};
  const Tables tables = free_body(m, {0.1, -0.2, 0.3}, {0.3, 0.5, 0.7});
  std::mt19937_64 engine(7);
  const Motion<double> motion = random_motion(engine, tables.robot());
  const Vector<double> w = motion.base_velocity.head(3), v = motion.base_velocity.tail(3);
  const Vector<double> alpha = motion.base_acceleration.head(3), a = motion.base_acceleration.tail(3);
  const auto of_I = [&](const Vector<double>& x) { return Vector<double>{I(0) * x(0), I(1) * x(1), I(2) * x(2)}; };
  const Vector<double> force = m * (a + cross(w, v) + cross(alpha, c) + cross(w, cross(w, c)) - g);
  const Vector<double> moment = of_I(alpha) + cross(w, of_I(w)) + cross(c, force);
  const Vector<double> wrench = inverse_dynamics_fully_actuated(tables.robot(), motion, {}).base_wrench;
  EXPECT_LT(distance(wrench, stacked(moment, force)), kRounding);
}

// Products of inertia have positive sign: a point mass off the axes makes the tensor's off-diagonals -m x y.
TEST(ReferenceDynamics, ProductsOfInertiaHavePositiveSign) {
  Tables tables("dumbbell", true);
  // Two unit masses at +-(1, 2, 3): central inertia with products 2 x y, 2 x z, 2 y z.
  tables.add_link("dumbbell", {2, {}, {2 * 13.0, 2 * 10.0, 2 * 5.0, 2 * 2.0, 2 * 3.0, 2 * 6.0}});
  Motion<double> motion = at_rest(Vector<double>());
  motion.base_velocity = {1, 2, 3, 0, 0, 0};  // a spin along the bar has no energy
  EXPECT_NEAR(kinetic_energy(tables.robot(), motion), 0, kRounding);
}

TEST(ReferenceDynamics, GravityIsAnExternalWrenchOnEveryLink) {
  for (const bool floating : {false, true}) {
    const Tables tables = crooked_tree(floating);
    const Robot robot = tables.robot();
    std::mt19937_64 engine(8);
    const Motion<double> motion = random_motion(engine, robot);
    const Vector<double> gravity{1, -2, -9};
    Loads<double> weights{Vector<double>(3), {}};
    const auto poses = link_poses(robot, motion.q);
    for (int i = 0; i < robot.links.size; ++i) {
      const Matrix<double> R = rotation_of(poses[static_cast<std::size_t>(i)]);
      const Vector<double> force = robot.links[i].mass * (transpose(R) * gravity);
      weights.external.push_back(stacked(cross(center_of_mass<double>(robot.links[i]), force), force));
    }
    const Forces<double> expected = inverse_dynamics_fully_actuated(robot, motion, {gravity, {}});
    const Forces<double> actual = inverse_dynamics_fully_actuated(robot, motion, weights);
    EXPECT_LT(distance(actual.tau, expected.tau), kRounding);
    EXPECT_LT(distance(actual.base_wrench, expected.base_wrench), kRounding);
  }
}

TEST(ReferenceDynamics, AnExternalWrenchDoesTheWorkOfItsLinksTwist) {
  const Tables tables = crooked_tree(true);
  const Robot robot = tables.robot();
  std::mt19937_64 engine(9);
  const Motion<double> motion = random_motion(engine, robot);
  const Forces<double> without = bias_forces(robot, motion, {Vector<double>(3), {}});
  for (int i = 0; i < robot.links.size; ++i) {
    Loads<double> loads{Vector<double>(3), std::vector<Vector<double>>(6, Vector<double>(6))};
    const Vector<double> wrench = uniform_vector(engine, 6, 1);
    loads.external[static_cast<std::size_t>(i)] = wrench;
    const Forces<double> with = bias_forces(robot, motion, loads);
    const double spared =
        dot(without.tau - with.tau, motion.qd) + dot(without.base_wrench - with.base_wrench, motion.base_velocity);
    const LinkMotion<double> link = link_motions(robot, motion)[static_cast<std::size_t>(i)];
    const Matrix<double> R = rotation_of(link.pose);
    const double power =
        dot(R * wrench.head(3), link.angular_velocity()) + dot(R * wrench.tail(3), link.velocity({0, 0, 0}));
    EXPECT_NEAR(spared, power, kRounding) << robot.links[i].name;
  }
}

TEST(ReferenceDynamics, ForwardInvertsInverse) {
  const double kInverted = 1e-9;  // rounding, times the condition number of H, about 100
  for (const bool floating : {false, true}) {
    const Tables tables = crooked_tree(floating);
    std::mt19937_64 engine(10);
    Motion<double> motion = random_motion(engine, tables.robot());
    Loads<double> loads{{1, -2, -9}, {}};
    for (int i = 0; i < 6; ++i) loads.external.push_back(uniform_vector(engine, 6, 1));
    const InverseDynamics<double> inverse = inverse_dynamics(tables.robot(), motion, loads);
    const Accelerations<double> forward = forward_dynamics(tables.robot(), motion, inverse.tau, loads);
    EXPECT_LT(distance(forward.qdd, motion.qdd), kInverted);
    EXPECT_LT(distance(forward.base_acceleration, inverse.base_acceleration), kInverted);
    motion.base_acceleration = inverse.base_acceleration;
    const Forces<double> full = inverse_dynamics_fully_actuated(tables.robot(), motion, loads);
    EXPECT_LT(distance(full.tau, inverse.tau), kRounding);
    if (floating) {
      EXPECT_LT(largest(full.base_wrench), kInverted);
    }
  }
}

TEST(ReferenceDynamics, InertiaColumnsAreForcesOfUnitAccelerations) {
  const Tables tables = crooked_tree(true);
  std::mt19937_64 engine(11);
  const Vector<double> q = uniform_vector(engine, 5, 3);
  const Matrix<double> H = joint_space_inertia(tables.robot(), q);
  for (int k = 0; k < 11; ++k) {
    Motion<double> motion = at_rest(q);
    if (k < 6) motion.base_acceleration(k) = 1;
    if (k >= 6) motion.qdd(k - 6) = 1;
    EXPECT_LT(distance(generalized_forces(tables.robot(), motion, {Vector<double>(3), {}}), H.col(k)), kRounding);
  }
}

TEST(ReferenceDynamics, TermsBoundForces) {
  for (const bool floating : {false, true}) {
    const Tables tables = crooked_tree(floating);
    std::mt19937_64 engine(12);
    const Sample s = random_sample(engine, tables.robot());
    const Loads<double> loads{s.gravity, s.external};
    const Vector<double> forces = generalized_forces(tables.robot(), s.motion, loads);
    const Vector<double> terms = force_terms(tables.robot(), s.motion, loads);
    // Terms measure vectors by their largest component; a component of a cross product may be twice as large.
    for (int i = 0; i < 11; ++i) EXPECT_LE(std::abs(forces(i)), 6 * terms(i));
  }
}

TEST(ReferenceDynamics, NoJoints) {
  const Tables tables = free_body(2, {}, {1, 1, 1});
  const Motion<double> motion = at_rest(Vector<double>());
  EXPECT_EQ(joint_space_inertia(tables.robot(), motion.q).rows(), 6);
  EXPECT_EQ(inverse_dynamics(tables.robot(), motion, {}).tau.rows(), 0);
  Tables fixed("plinth");
  fixed.add_link("plinth", {});
  EXPECT_TRUE(joint_space_inertia(fixed.robot(), motion.q).empty());
  EXPECT_TRUE(forward_dynamics(fixed.robot(), motion, {}, {}).qdd.empty());
}

}  // namespace
}  // namespace robcogen::reference::dynamics_test
