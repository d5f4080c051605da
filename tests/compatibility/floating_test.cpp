// Programs for version 0.4 of the first RobCoGen: templates over traits of a scalar, and a floating base. Each call
// gives the numbers of the library's own functions, and with dual numbers their derivatives.
#include <gtest/gtest.h>

#include <iit/robots/floating_walker/miscellaneous.h>

#include "../codegen/dual.h"
#include "equal.h"
#include "floating_walker.h"

namespace autodiff {

// What Eigen needs of a scalar.
inline Dual& operator+=(Dual& a, const Dual& b) {
  return a = a + b;
}
inline Dual& operator-=(Dual& a, const Dual& b) {
  return a = a - b;
}
inline Dual& operator*=(Dual& a, const Dual& b) {
  return a = a * b;
}

}  // namespace autodiff

template <>
struct Eigen::NumTraits<autodiff::Dual> : Eigen::GenericNumTraits<autodiff::Dual> {};

namespace iit::rbd::tpl {

template <>
struct TraitSelector<autodiff::Dual> {
  struct Trait {
    using Scalar = autodiff::Dual;
  };
};

}  // namespace iit::rbd::tpl

namespace robcogen::test::floating_test {
namespace {

using autodiff::Dual;

class FloatingBase : public testing::Test {
 protected:
  Container<old::Traits> robot;
  const old::JointState& q = robot.q;
  const old::JointState &qd = robot.qd, &qdd = robot.qdd;
  const robcogen::Twist twist{robot.velocity};
  const robcogen::SpatialAcceleration spatial{robot.acceleration};
  const robcogen::Gravity g{robot.gravity.tail<3>()};
  old::JointState joints, other{0.1, 0.2, -0.5};
  iit::rbd::Vector6D base;
  old::LinkDataMap<iit::rbd::ForceVector> wrenches{iit::rbd::ForceVector::Zero()};
  own::LinkWrenches external;

  FloatingBase() {
    for (const auto link : old::orderedLinkIDs) {
      wrenches[link] = iit::rbd::ForceVector::LinSpaced(0.5 + static_cast<int>(link), 3.0);
      external[static_cast<int>(link)] = robcogen::Wrench(wrenches[link]);
    }
  }

  void expect(const own::InverseDynamics& result) const {
    expect_equal(joints, result.tau);
    expect_equal(base, result.base_acceleration.vector());
  }
  void expect(const own::GeneralizedForce& result) const {
    expect_equal(joints, result.tau);
    expect_equal(base, result.base_wrench.vector());
  }
  void expect(const own::GeneralizedAcceleration& result) const {
    expect_equal(joints, result.qdd);
    expect_equal(base, result.base_acceleration.vector());
  }
};

TEST_F(FloatingBase, Declarations) {
  static_assert(old::tpl::Traits<double>::floating_base, "");
  static_assert(std::is_same<old::Traits::Trait, iit::rbd::DoubleTrait>::value, "");
  static_assert(std::is_same<old::tpl::MotionTransforms<iit::rbd::DoubleTrait>, old::MotionTransforms>::value, "");
  static_assert(std::is_same<old::dyn::tpl::JSIM<iit::rbd::DoubleTrait>, old::dyn::JSIM>::value, "");
  EXPECT_EQ(old::linksCount, 4);
  EXPECT_EQ(robot.inertias.getMass_trunk(), 9.0);
  EXPECT_NEAR(robot.inertias.getTotalMass(), own::kTotalMass, kRounding);
}

TEST_F(FloatingBase, InverseDynamics) {
  auto& inverse = robot.inverse;
  const auto &a = robot.acceleration, &v = robot.velocity, &gravity = robot.gravity;
  inverse.id(joints, base, gravity, v, q, qd, qdd);
  expect(own::inverse_dynamics(q, qd, qdd, twist, g));
  inverse.id(joints, base, gravity, v, q, qd, qdd, wrenches);
  expect(own::inverse_dynamics(q, qd, qdd, twist, g, external));
  inverse.id_fully_actuated(base, joints, gravity, v, a, q, qd, qdd);
  expect(own::inverse_dynamics_fully_actuated(q, qd, qdd, twist, spatial, g));
  inverse.id_fully_actuated(base, joints, gravity, v, a, q, qd, qdd, wrenches);
  expect(own::inverse_dynamics_fully_actuated(q, qd, qdd, twist, spatial, g, external));
  inverse.G_terms_fully_actuated(base, joints, gravity, q);
  expect(own::gravity_forces(q, g));
  inverse.C_terms_fully_actuated(base, joints, v, q, qd);
  expect(own::coriolis_forces(q, qd, twist));
  inverse.setJointStatus(other);
  inverse.id(joints, base, gravity, v, qd, qdd);
  expect(own::inverse_dynamics(other, qd, qdd, twist, g));
  inverse.id(joints, base, gravity, v, qd, qdd, wrenches);
  expect(own::inverse_dynamics(other, qd, qdd, twist, g, external));
  inverse.id_fully_actuated(base, joints, gravity, v, a, qd, qdd);
  expect(own::inverse_dynamics_fully_actuated(other, qd, qdd, twist, spatial, g));
  inverse.id_fully_actuated(base, joints, gravity, v, a, qd, qdd, wrenches);
  expect(own::inverse_dynamics_fully_actuated(other, qd, qdd, twist, spatial, g, external));
  inverse.G_terms_fully_actuated(base, joints, gravity);
  expect(own::gravity_forces(other, g));
  inverse.C_terms_fully_actuated(base, joints, v, qd);
  expect(own::coriolis_forces(other, qd, twist));
}

TEST_F(FloatingBase, ForwardDynamics) {
  auto& forward = robot.forward;
  const auto &v = robot.velocity, &gravity = robot.gravity;
  forward.fd(joints, base, v, gravity, q, qd, qdd);
  expect(own::forward_dynamics(q, qd, qdd, twist, g));
  forward.fd(joints, base, v, gravity, q, qd, qdd, wrenches);
  expect(own::forward_dynamics(q, qd, qdd, twist, g, external));
  forward.setJointStatus(other);
  forward.fd(joints, base, v, gravity, qd, qdd);
  expect(own::forward_dynamics(other, qd, qdd, twist, g));
  forward.fd(joints, base, v, gravity, qd, qdd, wrenches);
  expect(own::forward_dynamics(other, qd, qdd, twist, g, external));
}

TEST_F(FloatingBase, JointSpaceInertia) {
  auto& jsim = robot.jsim;
  const Eigen::Matrix<double, 9, 9> H = own::joint_space_inertia(q);
  expect_equal(jsim(q), H);
  expect_equal(jsim.getF(), H.topRightCorner<6, 3>());
  expect_equal(jsim.getFixedBaseBlock(), H.bottomRightCorner<3, 3>());
  expect_equal(jsim.getWholeBodyInertia(), H.topLeftCorner<6, 6>());
  EXPECT_NEAR(jsim.getWholeBodyInertia().getMass(), own::kTotalMass, kRounding);
  jsim.computeL();
  expect_equal(jsim.getL().transpose() * jsim.getL(), H);
  jsim.computeInverse();
  expect_equal(jsim.getInverse() * H, Eigen::Matrix<double, 9, 9>::Identity());
  expect_equal(old::getWholeBodyCOM(robot.inertias, q, robot.homogeneous), own::center_of_mass(q));
}

// In the motion of the last call: forces by the joint forces and the base wrench, velocities by the energy.
TEST_F(FloatingBase, GettersOfLinks) {
  auto& inverse = robot.inverse;
  const auto& inertias = robot.inertias;
  inverse.id_fully_actuated(base, joints, robot.gravity, robot.velocity, robot.acceleration, q, qd, qdd, wrenches);
  const auto expect_forces = [&](const iit::rbd::ForceVector& at_base) {
    expect_equal(inverse.getForce_trunk(), at_base);
    EXPECT_NEAR(inverse.getForce_shin()(iit::rbd::LZ), joints(old::KNEE), kRounding);
    EXPECT_NEAR(inverse.getForce_thigh()(iit::rbd::AZ), joints(old::HIP), kRounding);
    EXPECT_NEAR(inverse.getForce_tail()(iit::rbd::AZ), joints(old::SWING), kRounding);
  };
  expect_forces(base);
  const auto energy = [](const auto& v, const auto& tensor) { return 0.5 * v.dot(tensor * v); };
  EXPECT_NEAR(
      energy(robot.velocity, inertias.getTensor_trunk()) +
          energy(inverse.getVelocity_shin(), inertias.getTensor_shin()) +
          energy(inverse.getVelocity_thigh(), inertias.getTensor_thigh()) +
          energy(inverse.getVelocity_tail(), inertias.getTensor_tail()),
      own::kinetic_energy(q, qd, twist), kRounding);
  inverse.id(joints, base, robot.gravity, robot.velocity, q, qd, qdd, wrenches);
  expect_forces(iit::rbd::ForceVector::Zero());
  const iit::rbd::Vector6D relative = base - robot.gravity;
  const iit::rbd::Vector6D carried = robot.motion.fr_tail_X_fr_trunk(q) * relative;
  EXPECT_NE(inverse.getAcceleration_tail(), carried);
}

// Dual numbers through every class: along the motion, transforms change as Jacobians say, and derivatives of forces by
// accelerations are the inertia matrix.
TEST_F(FloatingBase, DualNumbers) {
  Container<old::tpl::Traits<Dual>> dual;
  for (int j = 0; j < 3; ++j) dual.q(j).derivative = qd(j);
  const auto& X = dual.homogeneous.fr_trunk_X_foot(dual.q);
  robot.jacobians.fr_trunk_J_foot(q);
  const Eigen::Vector3d velocity =
      robot.jacobians.fr_trunk_J_foot.block<3, 2>(3, 0) * Eigen::Vector2d(qd(old::HIP), qd(old::KNEE));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(X(i, 3).derivative, velocity(i), kRounding);

  Container<old::tpl::Traits<Dual>> by_knee;
  by_knee.qdd(old::KNEE).derivative = 1;
  Container<old::tpl::Traits<Dual>>::Joints tau, acceleration;
  Container<old::tpl::Traits<Dual>>::Vector6 wrench, base_acceleration;
  by_knee.inverse.id_fully_actuated(
      wrench, tau, by_knee.gravity, by_knee.velocity, by_knee.acceleration, by_knee.q, by_knee.qd, by_knee.qdd);
  const auto& H = robot.jsim(q);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(wrench(i).derivative, H(i, 6 + old::KNEE), kRounding);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(tau(i).derivative, H(6 + i, 6 + old::KNEE), kRounding);
  EXPECT_NEAR(by_knee.inverse.getForce_shin()(iit::rbd::LZ).derivative, H(6 + old::KNEE, 6 + old::KNEE), kRounding);
  by_knee.jsim(by_knee.q);
  by_knee.jsim.computeL();
  by_knee.jsim.computeInverse();
  by_knee.forward.fd(
      acceleration, base_acceleration, by_knee.velocity, by_knee.gravity, by_knee.q, by_knee.qd, by_knee.qdd);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(acceleration(i).derivative, by_knee.jsim.getInverse()(6 + i, 6 + old::KNEE).value, kRounding);
}

// Derivatives by every input are those of the library's functions of derivatives.
TEST_F(FloatingBase, DerivativesByDualNumbers) {
  Eigen::Matrix<double, 18, 9> derivatives;
  for (int column = 0; column < 9; ++column) {
    Eigen::Matrix<Dual, 9, 1> x = motion().cast<Dual>();
    x(column).derivative = 1;
    const Eigen::Matrix<Dual, 18, 1> y = dynamics(x);
    for (int row = 0; row < 18; ++row) derivatives(row, column) = y(row).derivative;
  }
  expect_equal(derivatives, derivatives_of_dynamics());
}

// A library without SINGLE_PRECISION also serves float: the program compiles the kernels itself.
TEST_F(FloatingBase, SinglePrecision) {
  const Eigen::Matrix<double, 18, 1> expected = dynamics(motion());
  const Eigen::Matrix<double, 18, 1> result = dynamics<float>(motion().cast<float>()).cast<double>();
  constexpr double kRoundingOfFloat = 1e-4;  // some 100 operations, and the condition of the inertia matrix
  EXPECT_LE((result - expected).norm(), kRoundingOfFloat * expected.norm());
  EXPECT_GT((result - expected).norm(), 0);
}

}  // namespace
}  // namespace robcogen::test::floating_test
