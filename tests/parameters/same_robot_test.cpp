// P7, compiled: after an update, a robot with parameters behaves as the constant robot with the new values. The
// constant robot is made from the same document with numbers in place of names. (With the defaults, self-checks compare
// robots with parameters with the reference.)
#include <everywhere_fixed/everywhere_fixed.h>
#include <everywhere_fixed/reflection.h>
#include <others_fixed/others_fixed.h>
#include <others_fixed/reflection.h>

#include "same_robot.h"

namespace robcogen::test::same_robot_test {
namespace {

TEST(SameRobot, OthersFixedBase) {
  everywhere_fixed::Robot robot;
  robot.parameters.update(other_values<everywhere_fixed::ParameterValues>());
  expect_same<everywhere_fixed::Robot, others_fixed::Robot>(
      robot, everywhere_fixed::reflection::robot, others_fixed::reflection::robot);
}

// Updating one kind after the other equals updating both at once.
TEST(SameRobot, OthersInTwoSteps) {
  const auto values = other_values<everywhere_fixed::ParameterValues>();
  const everywhere_fixed::KinematicsParameters& kinematics = values;
  const everywhere_fixed::DynamicsParameters& dynamics = values;
  everywhere_fixed::Robot robot;
  robot.parameters.update(dynamics);
  robot.parameters.update(kinematics);
  expect_same<everywhere_fixed::Robot, others_fixed::Robot>(
      robot, everywhere_fixed::reflection::robot, others_fixed::reflection::robot);
}

TEST(SameRobot, OtherNumbers) {
  const everywhere_fixed::Parameters<> others(other_values<everywhere_fixed::ParameterValues>());
  expect_numbers(everywhere_fixed::reflection::robot, numbers_of(others), others_fixed::reflection::robot);
}

}  // namespace
}  // namespace robcogen::test::same_robot_test
