// Drives and limits as constants of generated libraries.
#include <driven/driven.h>
#include <driven/reflection.h>
#include <gtest/gtest.h>
#include <tuned/tuned.h>

#include <cmath>

namespace {

TEST(DriveConstants, OfTheModel) {
  constexpr robcogen::JointDrive swing = driven::kJointDrives[driven::index(driven::Joint::swing)];
  static_assert(swing.damping == 0.3 && swing.armature == 0.04);
  static_assert(driven::kJointDrives[driven::index(driven::Joint::knee)].damping == 0);
  static_assert(driven::Robot::kJointDrives[2].damping == 5.0);
  static_assert(driven::Robot::kJointDrives[1].friction == 0.6 && driven::kJointDrives[1].friction_velocity == 0.01);
  static_assert(driven::Robot::kJointDrives[1].stiffness == 12.0 && driven::kJointDrives[1].rest == -0.5);
  EXPECT_EQ(driven::reflection::robot.joints[1].drive.armature, 0.01);
}

TEST(DriveConstants, Limits) {
  static_assert(driven::kJointLimits[0].lower == -1.5 && driven::kJointLimits[0].upper == 1.25);
  static_assert(driven::kJointLimits[0].velocity == 12 && driven::kJointLimits[0].effort == 80);
  static_assert(driven::kJointLimits[1].upper == robcogen::kUnlimited);
}

// Values of parameters are their defaults.
TEST(DriveConstants, OfParameters) {
  EXPECT_EQ(tuned::kJointDrives[0].damping, 0.2);
  EXPECT_EQ(tuned::kJointDrives[0].armature, 0.08);
}

TEST(DriveConstants, ParametersChangeForces) {
  const tuned::Robot robot;
  tuned::Robot oiled = robot;
  tuned::ParameterValues values = robot.parameters.values();
  values.oil = 0.7;
  oiled.parameters.update(values);
  const tuned::JointState q(0.3, -0.2), qd(1.0, -2.0), qdd(0.5, 0.25);
  const tuned::JointState difference = oiled.inverse_dynamics(q, qd, qdd) - robot.inverse_dynamics(q, qd, qdd);
  EXPECT_NEAR(difference(0), 0.5, 1e-12);
  EXPECT_NEAR(difference(1), -1.0, 1e-12);
}

// Friction has the sign of the velocity, in both precisions, and is zero at rest.
TEST(DriveConstants, FrictionJumps) {
  const auto friction = [](double qd) {
    driven::JointState q, rates;
    q.setZero();
    rates << 0, 0, qd;
    return driven::passive_forces(q, rates)(2) - 5.0 * qd;
  };
  EXPECT_EQ(friction(0), 0);
  EXPECT_EQ(friction(1e-9), 1.5);
  EXPECT_EQ(friction(-1e-9), -1.5);
  EXPECT_NEAR(friction(2), 1.5, 1e-14);
  driven::f32::JointState q, rates;
  q.setZero();
  rates << 0, 0, -1e-6F;
  EXPECT_NEAR(driven::f32::passive_forces(q, rates)(2), -1.5F, 1e-5F);
  rates.setZero();
  EXPECT_EQ(driven::f32::passive_forces(q, rates)(2), 0.0F);
}

TEST(DriveConstants, Rotors) {
  static_assert(driven::kJointDrives[0].rotor_carrier == driven::index(driven::Link::trunk));
  static_assert(driven::kJointDrives[1].rotor_ratio == -6.0 && driven::kJointDrives[1].rotor_inertia == 3e-4);
  static_assert(driven::Robot::kJointDrives[2].rotor_carrier == driven::index(driven::Link::shank));
  // The joint's own axis, in axes of the trunk.
  EXPECT_NEAR(driven::kJointDrives[0].rotor_axis[0], 1, 1e-15);
  EXPECT_NEAR(driven::kJointDrives[0].rotor_axis[2], 0, 1e-15);
  EXPECT_NEAR(tuned::kJointDrives[1].rotor_axis[1], std::sqrt(0.2), 1e-15);
  // The joint's own axis, in axes of its child.
  EXPECT_EQ(tuned::kJointDrives[0].rotor_carrier, tuned::index(tuned::Link::arm));
  EXPECT_EQ(tuned::kJointDrives[0].rotor_axis[2], 1);
}

TEST(DriveConstants, MotorTorques) {
  const driven::JointState torques = driven::motor_torques(driven::JointState(9, 12, 40));
  EXPECT_DOUBLE_EQ(torques(0), 1);
  EXPECT_DOUBLE_EQ(torques(1), -2);
  EXPECT_DOUBLE_EQ(torques(2), 0.5);
}

}  // namespace
