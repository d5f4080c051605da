// Which kernels a function gets.
#include "pass/kernel_form.h"

#include <gtest/gtest.h>

#include <string>

#include "../backend/programs.h"

namespace robcogen::pass::kernel_form_test {
namespace {

using symbolic::Function;
using symbolic::KernelForm;
using symbolic::Program;

// A program of this many products, each of which needs an instruction.
Program products(int count) {
  std::string statements = "tmp x0 = q[0] * q[1]\n";
  for (int k = 1; k < count; ++k)
    statements += "tmp x" + std::to_string(k) + " = x" + std::to_string(k - 1) + " * q[1]\n";
  return test::leg_program(statements + "return tau x" + std::to_string(count - 1) + "\n");
}

// A program that fuses this many products into sums.
Program fused(int count) {
  std::string statements = "tmp x0 = q[0] + q[1]\n";
  for (int k = 1; k <= count; ++k) {
    const std::string x = "x" + std::to_string(k - 1), y = "y" + std::to_string(k);
    statements += "tmp " + y + " = " + x + " * q[1]\ntmp x" + std::to_string(k) + " = " + y + " + qd[0]\n";
  }
  return test::leg_program(statements + "return tau x" + std::to_string(count) + "\n");
}

Function with_core(int instructions, std::vector<int> angles) {
  Function f = test::function("dynamics", "dynamics", products(1));
  f.core.emplace();
  f.core->program = products(instructions);
  f.core->read = std::move(angles);
  return f;
}

TEST(KernelForm, ShortCoresAreCompiledIntoTheirCallers) {
  EXPECT_TRUE(kernel_form(with_core(64, {0}), {}).inlines_core);
  EXPECT_FALSE(kernel_form(with_core(65, {0}), {}).inlines_core);
}

TEST(KernelForm, EachCoreIsMeasuredByItself) {
  Function f = with_core(65, {0});
  f.core->in_lanes = products(64);
  EXPECT_FALSE(kernel_form(f, {}).inlines_core);
  EXPECT_TRUE(kernel_form(f, {}).inlines_core_in_lanes);
}

// Kernels of the kinematics are many. Where sines fill more than a vector, they call functions.
TEST(KernelForm, KernelsOfTheKinematicsCallFunctions) {
  const Function four = with_core(1, {0, 1, 2, 3}), five = with_core(1, {0, 1, 2, 3, 4});
  EXPECT_FALSE(kernel_form(four, {.is_kinematics = true}).calls_sines);
  const KernelForm form = kernel_form(five, {.is_kinematics = true});
  EXPECT_TRUE(form.calls_sines);
  EXPECT_FALSE(form.inlines_core);
  EXPECT_FALSE(kernel_form(five, {}).calls_sines);
}

TEST(KernelForm, LongProgramsInLanesCallACoreInLanes) {
  Function f = with_core(1, {0});
  EXPECT_FALSE(kernel_form(f, {}).has_own_lanes);
  f.in_lanes = products(512);
  EXPECT_TRUE(kernel_form(f, {}).has_own_lanes);
  f.in_lanes = products(513);
  EXPECT_FALSE(kernel_form(f, {}).has_own_lanes);
  f.core.reset();
  EXPECT_TRUE(kernel_form(f, {}).has_own_lanes);
}

TEST(KernelForm, OnlyOwnLanesHaveSmallAngles) {
  Function f = test::function("dynamics", "dynamics", products(1));
  f.in_lanes = test::leg_program("tmp u = gather q[0] q[1]\ntmp s = sin u\ntmp z = sum_lanes s\nreturn tau z\n");
  EXPECT_TRUE(kernel_form(f, {}).has_small_angles);
  f.in_lanes = products(1);
  EXPECT_FALSE(kernel_form(f, {}).has_small_angles);
}

symbolic::Level level(const Program& program, const GroupTraits& group = {}) {
  return kernel_form(test::function("dynamics", "dynamics", program), group).level;
}

bool gains(const Program& program, const GroupTraits& group = {}) {
  return level(program, group) != symbolic::Level::baseline;
}

TEST(KernelForm, LevelsPayForSinesAndFusedProducts) {
  EXPECT_FALSE(gains(fused(23)));
  EXPECT_TRUE(gains(fused(24)));
  EXPECT_FALSE(gains(products(100)));
  EXPECT_FALSE(gains(test::leg_program("tmp s = sin q[0]\nreturn tau s\n")));
  EXPECT_TRUE(gains(test::leg_program("tmp s = sin q[0]\ntmp t = sin q[1]\ntmp u = s * t\nreturn tau u\n")));
}

TEST(KernelForm, LevelsDoNotPayForFunctionsOfFramesThatAreNotDefault) {
  EXPECT_FALSE(gains(fused(24), {.is_kinematics = true}));
  EXPECT_TRUE(gains(fused(24), {.is_kinematics = true, .is_default = true}));
}

TEST(KernelForm, LongKernelsGainByTheRegistersOfAvx512) {
  EXPECT_EQ(level(fused(298)), symbolic::Level::avx2);  // and one sum more
  EXPECT_EQ(level(fused(299)), symbolic::Level::avx512);
  EXPECT_EQ(level(products(300)), symbolic::Level::baseline);
  Function f = test::function("dynamics", "dynamics", fused(600));
  f.in_lanes = fused(150);
  EXPECT_EQ(kernel_form(f, {}).level, symbolic::Level::avx2);
}

TEST(KernelForm, LongResultsAreComputedForSingleStates) {
  const auto form = [](int rows, const std::string& role) {
    std::string zeros;
    for (int k = 0; k < rows * rows; ++k) zeros += " 0";
    const std::string shape = std::to_string(rows) + " " + std::to_string(rows);
    const Program program = test::described_program(
        "program m\ninput q joint_position a\noutput M " + role + " " + shape + "\nreturn M" + zeros + "\n");
    return kernel_form(test::function("m", "m", program), {}).takes_single_states;
  };
  EXPECT_FALSE(form(63, "matrix"));
  EXPECT_TRUE(form(64, "matrix"));
  EXPECT_FALSE(form(64, "inertia_matrix"));  // symmetric: written in place
}

}  // namespace
}  // namespace robcogen::pass::kernel_form_test
