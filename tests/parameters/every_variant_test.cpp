// P7, compiled, with all functions: a robot with parameters behaves as the constant robot with their values, for the
// defaults and, with a floating base, for others.
#include <constant_fixed/constant_fixed.h>
#include <constant_fixed/reflection.h>
#include <constant_floating/constant_floating.h>
#include <constant_floating/reflection.h>
#include <everywhere_fixed/everywhere_fixed.h>
#include <everywhere_fixed/reflection.h>
#include <everywhere_floating/everywhere_floating.h>
#include <everywhere_floating/reflection.h>
#include <others_floating/others_floating.h>
#include <others_floating/reflection.h>

#include "same_robot.h"

namespace robcogen::test {
namespace {

TEST(EveryVariant, DefaultsFixedBase) {
  expect_same<everywhere_fixed::Robot, constant_fixed::Robot>(
      {}, everywhere_fixed::reflection::robot, constant_fixed::reflection::robot);
}

TEST(EveryVariant, DefaultsFloatingBase) {
  expect_same<everywhere_floating::Robot, constant_floating::Robot>(
      {}, everywhere_floating::reflection::robot, constant_floating::reflection::robot);
}

TEST(EveryVariant, OthersFloatingBase) {
  everywhere_floating::Robot robot;
  robot.parameters.update(other_values<everywhere_floating::ParameterValues>());
  expect_same<everywhere_floating::Robot, others_floating::Robot>(
      robot, everywhere_floating::reflection::robot, others_floating::reflection::robot);
}

TEST(EveryVariant, DefaultNumbers) {
  expect_numbers(
      everywhere_fixed::reflection::robot, numbers_of(everywhere_fixed::Parameters<>()),
      constant_fixed::reflection::robot);
}

}  // namespace
}  // namespace robcogen::test
