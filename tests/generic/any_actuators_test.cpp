// Cylinders of a robot that is chosen at run time: a leg whose knee is a four-bar.
#include <four_bar_leg/four_bar_leg.h>
#include <four_bar_leg/reflection.h>
#include <gtest/gtest.h>

#include "allocation_hook.h"
#include "message_of.h"
#include "robcogen/any_robot.h"

namespace robcogen::test::any_actuators_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

AnyRobot leg() {
  return make_any<four_bar_leg::Robot>(four_bar_leg::reflection::robot);
}

TEST(AnyActuators, HaveNames) {
  const AnyRobot robot = leg();
  ASSERT_EQ(robot.tables().actuators.size, 2);
  EXPECT_STREQ(robot.tables().actuators[0].name, "hip_cylinder");
  EXPECT_EQ(robot.find_actuator("knee_cylinder"), 1);
  EXPECT_EQ(robot.find_actuator("ankle_cylinder"), -1);
}

TEST(AnyActuators, HaveLengthsRatesAndLeverArms) {
  const AnyRobot robot = leg();
  const VectorXd q = Eigen::Vector3d(0.2, 0.1, -0.3), v = Eigen::Vector3d(0.5, -1.5, 2.0);
  VectorXd lengths(2), velocities(2);
  MatrixXd J(2, 3);
  {
    const NoAllocation during("AnyRobot");
    robot.actuator_lengths(q, lengths);
    robot.actuator_velocities(q, v, velocities);
    robot.actuator_jacobian(q, J);
  }
  EXPECT_EQ(lengths, four_bar_leg::actuator_lengths(q));
  EXPECT_EQ(velocities, four_bar_leg::actuator_velocities(q, v));
  EXPECT_EQ(J, four_bar_leg::actuator_jacobian(q));
  EXPECT_LT((velocities - J * v).norm(), 1e-14);
}

TEST(AnyActuators, SayWhatIsWrong) {
  const AnyRobot robot = leg();
  const VectorXd three = VectorXd::Zero(3);
  VectorXd two(2), one(1);
  EXPECT_EQ(
      message_of([&] { robot.actuator_lengths(three, one); }),
      "actuator_lengths of FourBarLeg: lengths has 1 elements and must have 2");
  EXPECT_EQ(
      message_of([&] { robot.actuator_velocities(three, two, two); }),
      "actuator_velocities of FourBarLeg: v has 2 elements and must have 3");
  MatrixXd wide(3, 3);
  EXPECT_EQ(
      message_of([&] { robot.actuator_jacobian(three, wide); }),
      "actuator_jacobian of FourBarLeg: a column of J has 3 elements and must have 2");
  EXPECT_EQ(
      message_of([&] { robot.actuator_jacobian(three, wide.topRows(2)); }),
      "actuator_jacobian: the columns of J must be contiguous");
  reflection::Robot tables = four_bar_leg::reflection::robot;
  tables.actuator_kernels = {};
  EXPECT_EQ(
      message_of([&] { make_any<four_bar_leg::Robot>(tables).actuator_lengths(three, two); }),
      "actuator_lengths of FourBarLeg: the robot has no actuators, or its library leaves out this function");
}

}  // namespace
}  // namespace robcogen::test::any_actuators_test
