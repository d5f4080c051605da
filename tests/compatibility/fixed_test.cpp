// Programs for version 5 of the first RobCoGen: plain classes, a fixed base, and parameters. Each call gives the
// numbers of the library's own functions.
#include <gtest/gtest.h>

#include <sstream>

#include <fixed_walker/fixed_walker.h>
#include <iit/robots/fixed/declarations.h>
#include <iit/robots/fixed/default_dynparams_getter.h>
#include <iit/robots/fixed/forward_dynamics.h>
#include <iit/robots/fixed/inertia_properties.h>
#include <iit/robots/fixed/inverse_dynamics.h>
#include <iit/robots/fixed/jacobians.h>
#include <iit/robots/fixed/joint_data_map.h>
#include <iit/robots/fixed/jsim.h>
#include <iit/robots/fixed/link_data_map.h>
#include <iit/robots/fixed/miscellaneous.h>
#include <iit/robots/fixed/rbd_types.h>
#include <iit/robots/fixed/traits.h>
#include <iit/robots/fixed/transforms.h>
#include <iit/robots/parametric_walker/default_dynparams_getter.h>
#include <iit/robots/parametric_walker/miscellaneous.h>
#include <iit/robots/parametric_walker/traits.h>
#include <parametric/parametric_walker/parametric_walker.h>

#include "equal.h"

namespace robcogen::test::fixed_test {
namespace {

namespace old = iit::FixedWalker;
namespace own = ::fixed_walker;

class FixedBase : public testing::Test {
 protected:
  old::HomogeneousTransforms homogeneous;
  old::MotionTransforms motion;
  old::ForceTransforms force;
  old::Jacobians jacobians;
  old::dyn::InertiaProperties inertias;
  old::dyn::InverseDynamics inverse{inertias, motion};
  old::dyn::ForwardDynamics forward{inertias, motion};
  old::dyn::JSIM jsim{inertias, force};
  const old::JointState q{0.3, -0.7, 1.1}, qd{0.5, -1.2, 0.8}, qdd{-0.4, 2.0, 0.6}, other{0.1, 0.2, -0.5};
  old::JointState result;
  old::LinkDataMap<old::Force> wrenches{old::Force::Zero()};
  own::LinkWrenches external;

  FixedBase() {
    for (const old::LinkIdentifiers link : old::orderedLinkIDs) {
      wrenches[link] = old::Force::LinSpaced(0.5 + static_cast<int>(link), 3.0);
      external[static_cast<int>(link)] = robcogen::Wrench(wrenches[link]);
    }
  }
};

TEST_F(FixedBase, Declarations) {
  EXPECT_EQ(old::JointSpaceDimension, 3);
  EXPECT_EQ(old::jointsCount, 3);
  EXPECT_EQ(old::linksCount, 4);
  EXPECT_EQ(old::KNEE, 0);
  EXPECT_EQ(old::SWING, 2);
  EXPECT_EQ(old::TRUNK, 0);
  EXPECT_EQ(old::THIGH, 3);
  EXPECT_EQ(old::orderedJointIDs[1], old::HIP);
  static_assert(std::is_same<old::Column3d, old::JointState>::value, "");
  static_assert(std::is_same<old::tpl::JointState<float>, Eigen::Matrix<float, 3, 1>>::value, "");
  static_assert(std::is_same<old::Traits::JointState, old::JointState>::value, "");
  static_assert(std::is_same<old::Traits::FwdDynEngine, old::dyn::ForwardDynamics>::value, "");
  static_assert(std::is_same<old::Traits::InvDynEngine, old::dyn::InverseDynamics>::value, "");
  EXPECT_EQ(old::Traits::joints_count, 3);
  EXPECT_EQ(old::Traits::links_count, 4);
  EXPECT_FALSE(old::Traits::floating_base);
  EXPECT_EQ(old::Traits::orderedJointIDs()[0], old::KNEE);
  EXPECT_EQ(old::Traits::orderedLinkIDs()[2], old::SHIN);
  EXPECT_EQ(old::g, iit::rbd::g);
}

TEST_F(FixedBase, DataMaps) {
  old::LinkDataMap<double> links(1.5);
  links[old::SHIN] = 2;
  old::LinkDataMap<double> copy(links);
  copy[old::TAIL] = 3;
  EXPECT_EQ(links[old::TAIL], 1.5);
  links = copy;
  std::ostringstream text;
  text << links;
  EXPECT_EQ(text.str(), "   trunk = 1.5   tail = 3   shin = 2   thigh = 1.5");
  old::JointDataMap<int> joints(4);
  joints[old::HIP] = 5;
  std::ostringstream other_text;
  other_text << joints;
  EXPECT_EQ(other_text.str(), "   KNEE = 4   HIP = 5   SWING = 4");
  joints = 6;
  EXPECT_EQ(joints[old::KNEE], 6);
}

TEST_F(FixedBase, Transforms) {
  expect_equal(homogeneous.fr_trunk_X_foot(q), own::transforms::homogeneous::fr_trunk_X_foot(q));
  expect_equal(motion.fr_trunk_X_foot.update(q), own::transforms::motion::fr_trunk_X_foot(q));
  expect_equal(force.fr_trunk_X_foot(q), own::transforms::force::fr_trunk_X_foot(q));
  // Objects keep their last value, and are matrices.
  const old::HomogeneousTransforms::Type_fr_trunk_X_foot& kept = homogeneous.fr_trunk_X_foot;
  const old::HomogeneousTransforms::MatrixType product = kept * homogeneous.foot_X_fr_shin;
  expect_equal(kept, own::transforms::homogeneous::fr_trunk_X_foot(q));
  expect_equal(
      product, own::transforms::homogeneous::fr_trunk_X_foot(q) * own::transforms::homogeneous::foot_X_fr_shin(q));
  expect_equal(
      iit::rbd::Utils::positionVector(kept),
      product.topRightCorner<3, 1>() -
          product.leftCols<3>().topRows<3>() * homogeneous.foot_X_fr_shin.topRightCorner<3, 1>());
  // Transforms between links exist although no list asks for them.
  const old::HomogeneousTransforms::MatrixType chain =
      homogeneous.fr_trunk_X_fr_thigh(q) * homogeneous.fr_thigh_X_fr_shin(q);
  homogeneous.fr_shin_X_fr_thigh(q);
  expect_equal(homogeneous.fr_shin_X_fr_thigh * homogeneous.fr_thigh_X_fr_shin, Eigen::Matrix4d::Identity());
  expect_equal(chain * homogeneous.foot_X_fr_shin.inverse(), kept);
}

// A copy of an object has its own state. A transform that belongs to no object, copied or constructed, changes none.
TEST_F(FixedBase, CopiesOfTransforms) {
  inverse.setJointStatus(q);
  old::MotionTransforms copy(motion);
  old::dyn::ForwardDynamics dynamics(inertias, copy);
  motion.fr_thigh_X_fr_trunk(other);
  dynamics.fd(result, qd, qdd);
  expect_equal(result, own::forward_dynamics(q, qd, qdd));
  copy.fr_thigh_X_fr_trunk(other);
  old::MotionTransforms::Type_fr_thigh_X_fr_trunk copied(copy.fr_thigh_X_fr_trunk), constructed;
  expect_equal(copied, copy.fr_thigh_X_fr_trunk);
  expect_equal(copied(q), constructed(q));
  dynamics.fd(result, qd, qdd);
  expect_equal(result, own::forward_dynamics(old::JointState(q(0), other(1), q(2)), qd, qdd));
  copy = motion;
  dynamics.fd(result, qd, qdd);
  expect_equal(result, own::forward_dynamics(old::JointState(q(0), other(1), q(2)), qd, qdd));
  const old::HomogeneousTransforms::Type_foot_X_fr_shin constant;
  expect_equal(constant, homogeneous.foot_X_fr_shin);
}

TEST_F(FixedBase, Jacobians) {
  expect_equal(jacobians.fr_trunk_J_foot(q), own::jacobians::fr_trunk_J_foot(q));
  expect_equal(jacobians.head_J_foot.update(q), own::jacobians::head_J_foot(q));
  const Eigen::Vector3d velocity = jacobians.fr_trunk_J_foot.block<3, 2>(iit::rbd::LX, 0) * Eigen::Vector2d(1, 2);
  expect_equal(velocity, own::jacobians::fr_trunk_J_foot(q).bottomRows<3>() * Eigen::Vector2d(1, 2));
}

TEST_F(FixedBase, InertiaProperties) {
  EXPECT_EQ(inertias.getMass_shin(), 0.9);
  expect_equal(inertias.getCOM_thigh(), Eigen::Vector3d(0.15, -0.02, 0.0));
  EXPECT_NEAR(inertias.getTotalMass(), own::kTotalMass, kRounding);
  const old::InertiaMatrix& tensor = inertias.getTensor_tail();
  EXPECT_EQ(tensor.getMass(), 0.7);
  expect_equal(tensor.getCOM(), inertias.getCOM_tail());
  EXPECT_EQ(tensor(iit::rbd::AX, iit::rbd::AY), -0.001);
  expect_equal(old::getWholeBodyCOM(inertias, q, homogeneous), own::center_of_mass(q));
  expect_equal(old::getWholeBodyCOM(inertias, homogeneous), own::center_of_mass(q));
  // The overload without q sees transforms that are updated one by one.
  homogeneous.fr_trunk_X_fr_tail(other);
  expect_equal(old::getWholeBodyCOM(inertias, homogeneous), own::center_of_mass(old::JointState(q(0), q(1), other(2))));
}

TEST_F(FixedBase, InverseDynamics) {
  inverse.id(result, q, qd, qdd);
  expect_equal(result, own::inverse_dynamics(q, qd, qdd));
  inverse.id(result, q, qd, qdd, wrenches);
  expect_equal(result, own::inverse_dynamics(q, qd, qdd, external));
  inverse.G_terms(result, q);
  expect_equal(result, own::gravity_forces(q));
  inverse.C_terms(result, q, qd);
  expect_equal(result, own::coriolis_forces(q, qd));
  // The state of the overloads without q belongs to the transforms, so the object of forward dynamics has it too.
  inverse.setJointStatus(other);
  expect_equal(motion.fr_shin_X_fr_thigh, own::transforms::motion::fr_shin_X_fr_thigh(other));
  inverse.id(result, qd, qdd);
  expect_equal(result, own::inverse_dynamics(other, qd, qdd));
  inverse.id(result, qd, qdd, wrenches);
  expect_equal(result, own::inverse_dynamics(other, qd, qdd, external));
  inverse.G_terms(result);
  expect_equal(result, own::gravity_forces(other));
  inverse.C_terms(result, qd);
  expect_equal(result, own::coriolis_forces(other, qd));
  forward.fd(result, qd, qdd);
  expect_equal(result, own::forward_dynamics(other, qd, qdd));
  motion.fr_thigh_X_fr_trunk(q);
  forward.fd(result, qd, qdd);
  expect_equal(result, own::forward_dynamics(old::JointState(other(0), q(1), other(2)), qd, qdd));
}

TEST_F(FixedBase, ForwardDynamics) {
  forward.fd(result, q, qd, qdd);
  expect_equal(result, own::forward_dynamics(q, qd, qdd));
  forward.fd(result, q, qd, qdd, wrenches);
  expect_equal(result, own::forward_dynamics(q, qd, qdd, external));
  forward.setJointStatus(other);
  forward.fd(result, qd, qdd);
  expect_equal(result, own::forward_dynamics(other, qd, qdd));
  forward.fd(result, qd, qdd, wrenches);
  expect_equal(result, own::forward_dynamics(other, qd, qdd, external));
  // An argument may be the result.
  result = qdd;
  forward.fd(result, q, qd, result);
  expect_equal(result, own::forward_dynamics(q, qd, qdd));
}

TEST_F(FixedBase, JointSpaceInertia) {
  expect_equal(jsim(q), own::joint_space_inertia(q));
  jsim.computeL();
  expect_equal(jsim.getL(), own::joint_space_inertia_factor(q).L());
  expect_equal(jsim.getL().transpose() * jsim.getL(), jsim);
  jsim.computeInverse();
  expect_equal(jsim.getInverse() * jsim, Eigen::Matrix3d::Identity());
  jsim.update(other);
  expect_equal(jsim, own::joint_space_inertia(other));
}

// Velocities by the energy, forces by the joint forces, accelerations by differences of velocities.
TEST_F(FixedBase, GettersOfLinks) {
  inverse.id(result, q, qd, qdd, wrenches);
  EXPECT_NEAR(inverse.getForce_shin()(iit::rbd::LZ), result(old::KNEE), kRounding);
  EXPECT_NEAR(inverse.getForce_thigh()(iit::rbd::AZ), result(old::HIP), kRounding);
  EXPECT_NEAR(inverse.getForce_tail()(iit::rbd::AZ), result(old::SWING), kRounding);
  const auto energy = [](const auto& v, const auto& tensor) { return 0.5 * v.dot(tensor * v); };
  EXPECT_NEAR(
      energy(inverse.getVelocity_shin(), inertias.getTensor_shin()) +
          energy(inverse.getVelocity_thigh(), inertias.getTensor_thigh()) +
          energy(inverse.getVelocity_tail(), inertias.getTensor_tail()),
      own::kinetic_energy(q, qd), kRounding);
  const old::Acceleration acceleration = inverse.getAcceleration_shin();
  constexpr double kStep = 1e-5, kTruncation = 1e-8;
  const auto velocity = [&](double t) -> old::Velocity {
    inverse.id(result, q + t * qd + t * t / 2 * qdd, qd + t * qdd, qdd);
    return inverse.getVelocity_shin();
  };
  const old::Acceleration difference = (velocity(kStep) - velocity(-kStep)) / (2 * kStep);
  old::Acceleration upwards = old::Acceleration::Zero();
  upwards(iit::rbd::LZ) = iit::rbd::g;
  const old::Acceleration gravity =
      motion.fr_shin_X_fr_thigh(q) * old::Acceleration(motion.fr_thigh_X_fr_trunk(q) * upwards);
  EXPECT_LE((acceleration - difference - gravity).cwiseAbs().maxCoeff(), kTruncation);
  inverse.G_terms(result, q);
  expect_equal(inverse.getAcceleration_shin(), gravity);
}

namespace with = parametric;
namespace library = parametric::parametric_walker;

struct Measured : with::RuntimeParamsGetter, with::ParamsGetter_lengths, with::ParamsGetter_angles {
  double mass = 1.1, length = 0.4, twist = 0.3;
  double getValue_tail_mass() const override { return mass; }
  double getValue_shin_length() const override { return length; }
  double getValue_twist() const override { return twist; }
};

library::Parameters<> parameters_of(const Measured& m) {
  library::ParameterValues values;
  values.tail_mass = m.mass;
  values.shin_length = m.length;
  values.twist = m.twist;
  return library::Parameters<>(values);
}

void expect_same_robot(
    with::dyn::InertiaProperties& inertias,
    with::HomogeneousTransforms& homogeneous,
    with::MotionTransforms& motion,
    with::ForceTransforms& force,
    with::Jacobians& jacobians,
    const library::Parameters<>& parameters) {
  const with::JointState q(0.3, -0.7, 1.1), qd(0.5, -1.2, 0.8), qdd(-0.4, 2.0, 0.6);
  with::JointState result;
  with::dyn::InverseDynamics inverse(inertias, motion);
  with::dyn::ForwardDynamics forward(inertias, motion);
  with::dyn::JSIM jsim(inertias, force);
  inverse.id(result, q, qd, qdd);
  expect_equal(result, library::inverse_dynamics(parameters, q, qd, qdd));
  EXPECT_NEAR(inverse.getForce_shin()(iit::rbd::LZ), result(with::KNEE), kRounding);
  forward.fd(result, q, qd, qdd);
  expect_equal(result, library::forward_dynamics(parameters, q, qd, qdd));
  expect_equal(jsim(q), library::joint_space_inertia(parameters, q));
  expect_equal(homogeneous.fr_trunk_X_foot(q), library::transforms::homogeneous::fr_trunk_X_foot(parameters, q));
  expect_equal(jacobians.fr_trunk_J_foot(q), library::jacobians::fr_trunk_J_foot(parameters, q));
  expect_equal(with::getWholeBodyCOM(inertias, q, homogeneous), library::center_of_mass(parameters, q));
  EXPECT_NEAR(inertias.getTotalMass(), library::total_mass(parameters), kRounding);
}

TEST(Parameters, OfVersion5) {
  with::dyn::InertiaProperties inertias;
  with::HomogeneousTransforms homogeneous;
  with::MotionTransforms motion;
  with::ForceTransforms force;
  with::Jacobians jacobians;
  expect_same_robot(inertias, homogeneous, motion, force, jacobians, library::Parameters<>());
  const Measured m;
  with::RuntimeInertiaParams masses;
  with::Params_lengths lengths;
  with::Params_angles angles;
  EXPECT_EQ(masses.tail_mass, 0.7);
  masses.tail_mass = m.mass;
  lengths.shin_length = m.length;
  angles.twist = m.twist;
  inertias.updateParameters(masses);
  homogeneous.updateParams(lengths, angles);
  motion.updateParams(lengths, angles);
  force.updateParams(lengths, angles);
  jacobians.updateParameters(lengths, angles);
  EXPECT_EQ(inertias.getMass_tail(), m.mass);
  expect_same_robot(inertias, homogeneous, motion, force, jacobians, parameters_of(m));
  // A copy has its own parameters.
  with::HomogeneousTransforms copy(homogeneous);
  homogeneous.updateParams(with::Params_lengths(), angles);
  expect_same_robot(inertias, copy, motion, force, jacobians, parameters_of(m));
}

TEST(Parameters, OfVersion04) {
  Measured m;
  with::dyn::InertiaProperties inertias(m);
  with::HomogeneousTransforms homogeneous(m, m);
  with::MotionTransforms motion(m, m);
  with::ForceTransforms force(m, m);
  with::Jacobians jacobians(m, m);
  expect_same_robot(inertias, homogeneous, motion, force, jacobians, parameters_of(m));
  m.mass = 0.2;
  m.length = 0.1;
  inertias.updateParameters();
  homogeneous.updateParameters();
  motion.updateParameters();
  force.updateParameters();
  jacobians.updateParameters();
  expect_same_robot(inertias, homogeneous, motion, force, jacobians, parameters_of(m));
  with::dyn::DefaultParamsGetter defaults;
  EXPECT_EQ(defaults.getValue_tail_mass(), 0.7);
}

}  // namespace
}  // namespace robcogen::test::fixed_test
