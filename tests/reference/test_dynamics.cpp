// The reference's dynamics against closed forms of small robots, and against itself where one function inverts another.
#include <gtest/gtest.h>

#include "sample_robots.h"

namespace robcogen::reference {
namespace {

// Rounding of a few dozen operations, relative to forces of order 100.
constexpr double kRounding = 1e-11;
constexpr double kG = 9.81;

Motion<double> motion_of(const VectorX<double>& q, const VectorX<double>& qd, const VectorX<double>& qdd) {
  return {q, qd, qdd};
}

TEST(ReferenceDynamics, Pendulum) {
  const double m = 2.5, l = 0.6, I = 0.08;
  const Tables tables = pendulum(m, l, I);
  for (const double q : {0.0, 0.4, 1.5, -2.8}) {
    const Motion<double> motion = motion_of(
        VectorX<double>::Constant(1, q), VectorX<double>::Constant(1, 1.7), VectorX<double>::Constant(1, -3.1));
    const double gravity = m * kG * l * std::sin(q);
    EXPECT_NEAR(inverse_dynamics(tables.robot(), motion, {}).tau(0), (I + m * l * l) * -3.1 + gravity, kRounding);
    EXPECT_NEAR(joint_space_inertia(tables.robot(), motion.q)(0, 0), I + m * l * l, kRounding);
    EXPECT_NEAR(gravity_forces(tables.robot(), motion.q, {0, 0, -kG}).tau(0), gravity, kRounding);
    EXPECT_NEAR(gravity_forces(tables.robot(), motion.q, {2, 0, 0}).tau(0), -m * l * 2 * std::cos(q), kRounding);
    EXPECT_NEAR(coriolis_forces(tables.robot(), motion).tau(0), 0, kRounding);
    const VectorX<double> tau = VectorX<double>::Constant(1, 5.0);
    EXPECT_NEAR(forward_dynamics(tables.robot(), motion, tau, {}).qdd(0), (5.0 - gravity) / (I + m * l * l), kRounding);
  }
}

TEST(ReferenceDynamics, PendulumSupport) {
  // Hanging at rest the support carries the weight; swinging through the bottom also the centripetal force.
  const Tables tables = pendulum(2, 0.5, 0.1);
  const VectorX<double> zero = VectorX<double>::Zero(1);
  const Vector6<double> wrench =
      bias_forces(tables.robot(), motion_of(zero, VectorX<double>::Constant(1, 3.0), zero), {}).base_wrench;
  EXPECT_NEAR(wrench(5), 2 * kG + 2 * 0.5 * 9.0, kRounding);
  EXPECT_NEAR(wrench.head<5>().norm(), 0, kRounding);
}

TEST(ReferenceDynamics, DoublePendulum) {
  const double m1 = 1.2, l1 = 0.7, m2 = 0.8, l2 = 0.45;
  const Tables tables = double_pendulum(m1, l1, m2, l2);
  std::mt19937_64 engine(5);
  for (int sample = 0; sample < 10; ++sample) {
    const Motion<double> motion = random_motion(engine, tables.robot());
    const double q1 = motion.q(0), q2 = motion.q(1), w1 = motion.qd(0), w2 = motion.qd(1);
    const double coupling = m2 * l1 * l2;
    Eigen::Matrix2d H;
    H(0, 0) = (m1 + m2) * l1 * l1 + m2 * l2 * l2 + 2 * coupling * std::cos(q2);
    H(0, 1) = H(1, 0) = m2 * l2 * l2 + coupling * std::cos(q2);
    H(1, 1) = m2 * l2 * l2;
    const Eigen::Vector2d C(-coupling * std::sin(q2) * (2 * w1 * w2 + w2 * w2), coupling * std::sin(q2) * w1 * w1);
    const Eigen::Vector2d G(
        (m1 + m2) * kG * l1 * std::sin(q1) + m2 * kG * l2 * std::sin(q1 + q2), m2 * kG * l2 * std::sin(q1 + q2));
    EXPECT_LT((joint_space_inertia(tables.robot(), motion.q) - H).norm(), kRounding);
    EXPECT_LT((coriolis_forces(tables.robot(), motion).tau - C).norm(), kRounding);
    EXPECT_LT((gravity_forces(tables.robot(), motion.q, {0, 0, -kG}).tau - G).norm(), kRounding);
    EXPECT_LT((inverse_dynamics(tables.robot(), motion, {}).tau - (H * motion.qdd + C + G)).norm(), kRounding);
  }
}

TEST(ReferenceDynamics, CartPole) {
  const double M = 3, m = 0.6, l = 0.8;
  const Tables tables = cart_pole(M, m, l);
  std::mt19937_64 engine(6);
  for (int sample = 0; sample < 10; ++sample) {
    const Motion<double> motion = random_motion(engine, tables.robot());
    const double c = std::cos(motion.q(1)), s = std::sin(motion.q(1));
    const Eigen::Vector2d expected(
        (M + m) * motion.qdd(0) + m * l * c * motion.qdd(1) - m * l * s * motion.qd(1) * motion.qd(1),
        m * l * c * motion.qdd(0) + m * l * l * motion.qdd(1) + m * kG * l * s);
    EXPECT_LT((inverse_dynamics(tables.robot(), motion, {}).tau - expected).norm(), kRounding);
  }
}

TEST(ReferenceDynamics, FreeBodyObeysEulersEquations) {
  const Vector3<double> I(0.3, 0.5, 0.7);
  const Tables tables = free_body(4, {}, {I(0), I(1), I(2)});
  Motion<double> motion = at_rest<double>(VectorX<double>(0));
  motion.base_velocity << 1.0, -2.0, 0.5, 0.3, 0.2, -0.1;
  const Vector3<double> w = motion.base_velocity.head<3>();
  const Vector3<double> v = motion.base_velocity.tail<3>();
  const Loads<double> loads{Vector3<double>(1, 2, -9), {}};
  const Vector6<double> a = forward_dynamics(tables.robot(), motion, VectorX<double>(0), loads).base_acceleration;
  EXPECT_NEAR(a(0), (I(1) - I(2)) * w(1) * w(2) / I(0), kRounding);
  EXPECT_NEAR(a(1), (I(2) - I(0)) * w(2) * w(0) / I(1), kRounding);
  EXPECT_NEAR(a(2), (I(0) - I(1)) * w(0) * w(1) / I(2), kRounding);
  // The origin, its centre of mass, falls: classical acceleration = gravity.
  EXPECT_LT((a.tail<3>() + w.cross(v) - loads.gravity).norm(), kRounding);
}

TEST(ReferenceDynamics, FreeBodyWithOffsetCentreOfMass) {
  const double m = 4;
  const Vector3<double> c(0.1, -0.2, 0.3);
  const Vector3<double> I(0.3, 0.5, 0.7);
  const Tables tables = free_body(m, {c(0), c(1), c(2)}, {I(0), I(1), I(2)});
  std::mt19937_64 engine(7);
  const Motion<double> motion = random_motion(engine, tables.robot());
  const Vector3<double> w = motion.base_velocity.head<3>(), v = motion.base_velocity.tail<3>();
  const Vector3<double> alpha = motion.base_acceleration.head<3>(), a = motion.base_acceleration.tail<3>();
  const Vector3<double> g(0, 0, -kG);
  const Vector3<double> force = m * (a + w.cross(v) + alpha.cross(c) + w.cross(w.cross(c)) - g);
  const Vector3<double> Iw = I.cwiseProduct(w);
  const Vector3<double> moment = I.cwiseProduct(alpha) + w.cross(Iw) + c.cross(force);
  const Vector6<double> wrench = inverse_dynamics_fully_actuated(tables.robot(), motion, {}).base_wrench;
  EXPECT_LT((wrench.head<3>() - moment).norm(), kRounding);
  EXPECT_LT((wrench.tail<3>() - force).norm(), kRounding);
}

// Products of inertia have positive sign: a point mass off the axes makes the tensor's off-diagonals -m x y.
TEST(ReferenceDynamics, ProductsOfInertiaHavePositiveSign) {
  Tables tables("dumbbell", true);
  // Two unit masses at +-(1, 2, 3): central inertia with products 2 x y, 2 x z, 2 y z.
  tables.add_link("dumbbell", {2, {}, {2 * 13.0, 2 * 10.0, 2 * 5.0, 2 * 2.0, 2 * 3.0, 2 * 6.0}});
  Motion<double> motion = at_rest<double>(VectorX<double>(0));
  motion.base_velocity << 1, 2, 3, 0, 0, 0;  // a spin along the bar has no energy
  EXPECT_NEAR(kinetic_energy(tables.robot(), motion), 0, kRounding);
}

TEST(ReferenceDynamics, GravityIsAnExternalWrenchOnEveryLink) {
  for (const bool floating : {false, true}) {
    const Tables tables = crooked_tree(floating);
    const Robot robot = tables.robot();
    std::mt19937_64 engine(8);
    const Motion<double> motion = random_motion(engine, robot);
    const Vector3<double> gravity(1, -2, -9);
    Loads<double> weights{Vector3<double>::Zero(), {}};
    const auto poses = link_poses(robot, motion.q);
    for (int i = 0; i < robot.links.size; ++i) {
      const Vector3<double> force =
          rotation_of(poses[static_cast<std::size_t>(i)]).transpose() * gravity * robot.links[i].mass;
      Vector6<double> wrench;
      wrench << center_of_mass<double>(robot.links[i]).cross(force), force;
      weights.external.push_back(wrench);
    }
    const Forces<double> expected = inverse_dynamics_fully_actuated(robot, motion, {gravity, {}});
    const Forces<double> actual = inverse_dynamics_fully_actuated(robot, motion, weights);
    EXPECT_LT((actual.tau - expected.tau).norm(), kRounding);
    EXPECT_LT((actual.base_wrench - expected.base_wrench).norm(), kRounding);
  }
}

TEST(ReferenceDynamics, AnExternalWrenchDoesTheWorkOfItsLinksTwist) {
  const Tables tables = crooked_tree(true);
  const Robot robot = tables.robot();
  std::mt19937_64 engine(9);
  const Motion<double> motion = random_motion(engine, robot);
  for (int i = 0; i < robot.links.size; ++i) {
    Loads<double> loads{Vector3<double>::Zero(), std::vector<Vector6<double>>(6, Vector6<double>::Zero())};
    const Vector6<double> wrench = random_vector(engine, 6);
    loads.external[static_cast<std::size_t>(i)] = wrench;
    const Forces<double> without = bias_forces(robot, motion, {Vector3<double>::Zero(), {}});
    const Forces<double> with = bias_forces(robot, motion, loads);
    const double spared =
        (without.tau - with.tau).dot(motion.qd) + (without.base_wrench - with.base_wrench).dot(motion.base_velocity);
    const LinkMotion<double> link = link_motions(robot, motion)[static_cast<std::size_t>(i)];
    const Matrix3<double> R = rotation_of(link.pose);
    const double power = (R * wrench.head<3>()).dot(link.angular_velocity()) +
                         (R * wrench.tail<3>()).dot(link.velocity(Vector3<double>::Zero()));
    EXPECT_NEAR(spared, power, kRounding) << robot.links[i].name;
  }
}

TEST(ReferenceDynamics, ForwardInvertsInverse) {
  for (const bool floating : {false, true}) {
    const Tables tables = crooked_tree(floating);
    std::mt19937_64 engine(10);
    Motion<double> motion = random_motion(engine, tables.robot());
    Loads<double> loads{Vector3<double>(1, -2, -9), {}};
    for (int i = 0; i < 6; ++i) loads.external.push_back(random_vector(engine, 6));
    const InverseDynamics<double> inverse = inverse_dynamics(tables.robot(), motion, loads);
    const Accelerations<double> forward = forward_dynamics(tables.robot(), motion, inverse.tau, loads);
    EXPECT_LT((forward.qdd - motion.qdd).norm(), 100 * kRounding);
    EXPECT_LT((forward.base_acceleration - inverse.base_acceleration).norm(), 100 * kRounding);
    motion.base_acceleration = inverse.base_acceleration;
    const Forces<double> full = inverse_dynamics_fully_actuated(tables.robot(), motion, loads);
    if (floating) {
      EXPECT_LT(full.base_wrench.norm(), 100 * kRounding);
    }
    EXPECT_LT((full.tau - inverse.tau).norm(), kRounding);
  }
}

TEST(ReferenceDynamics, InertiaColumnsAreForcesOfUnitAccelerations) {
  const Tables tables = crooked_tree(true);
  std::mt19937_64 engine(11);
  const VectorX<double> q = 3 * random_vector(engine, 5);
  const MatrixX<double> H = joint_space_inertia(tables.robot(), q);
  for (int k = 0; k < 11; ++k) {
    Motion<double> motion = at_rest(q);
    if (k < 6) motion.base_acceleration(k) = 1;
    if (k >= 6) motion.qdd(k - 6) = 1;
    const Loads<double> weightless{Vector3<double>::Zero(), {}};
    EXPECT_LT((generalized_forces(tables.robot(), motion, weightless).value - H.col(k)).norm(), kRounding);
  }
}

TEST(ReferenceDynamics, MagnitudesBoundValues) {
  const Tables tables = crooked_tree(true);
  std::mt19937_64 engine(12);
  const Motion<double> motion = random_motion(engine, tables.robot());
  const GeneralizedForces<double> forces = generalized_forces(tables.robot(), motion, {});
  EXPECT_TRUE((forces.value.cwiseAbs().array() <= forces.magnitude.array()).all());
}

TEST(ReferenceDynamics, NoJoints) {
  const Tables tables = free_body(2, {}, {1, 1, 1});
  const Motion<double> motion = at_rest<double>(VectorX<double>(0));
  EXPECT_EQ(joint_space_inertia(tables.robot(), motion.q).rows(), 6);
  EXPECT_EQ(inverse_dynamics(tables.robot(), motion, {}).tau.size(), 0);
  Tables fixed("plinth");
  fixed.add_link("plinth", {});
  EXPECT_EQ(joint_space_inertia(fixed.robot(), motion.q).size(), 0);
  EXPECT_EQ(forward_dynamics(fixed.robot(), motion, VectorX<double>(0), {}).qdd.size(), 0);
}

}  // namespace
}  // namespace robcogen::reference
