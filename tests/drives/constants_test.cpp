// Drives and limits as constants of generated libraries.
#include <driven/driven.h>
#include <driven/reflection.h>
#include <gtest/gtest.h>
#include <tuned/tuned.h>

namespace {

TEST(DriveConstants, OfTheModel) {
  constexpr robcogen::JointDrive swing = driven::kJointDrives[driven::index(driven::Joint::swing)];
  static_assert(swing.damping == 0.3 && swing.armature == 0.04);
  static_assert(driven::kJointDrives[driven::index(driven::Joint::knee)].damping == 0);
  static_assert(driven::Robot::kJointDrives[2].damping == 5.0);
  EXPECT_EQ(driven::reflection::robot.joints[1].drive.armature, 0.01);
}

TEST(DriveConstants, Limits) {
  static_assert(driven::kJointLimits[0].lower == -1.5 && driven::kJointLimits[0].upper == 1.25);
  static_assert(driven::kJointLimits[0].velocity == 12 && driven::kJointLimits[0].effort == 80);
  static_assert(driven::kJointLimits[1].upper == robcogen::kUnlimited);
}

// Values of parameters are the defaults.
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

}  // namespace
