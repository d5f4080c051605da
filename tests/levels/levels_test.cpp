// The choice of the kernels' processor level: before main, by use_level, and within a shared library.
#include <dlfcn.h>

#include <gtest/gtest.h>

#include <puma560/puma560.h>
#include <puma560/reflection.h>
#include <quadruped/quadruped.h>
#include <quadruped/reflection.h>

namespace {

using robcogen::Level;
using State = puma560::JointState;

// Results of different levels differ by rounding only: by some bits of numbers below 100.
constexpr double kOtherRounding = 1e-12;

State angles(double first) {
  State q;
  for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = first + 0.7 * static_cast<double>(i);
  return q;
}

State forces(double first) {
  return puma560::inverse_dynamics(angles(first), State::Ones(), State::Ones());
}

// Constructed before main.
const State before_main = forces(0.3);

// True if the library has kernels above its baseline for this machine.
bool chooses() {
  return robcogen::best_level() != Level::baseline;
}

// The results of a function in many states, at this level: a column per state.
template <class Function>
Eigen::MatrixXd of_level(Level level, Function function) {
  puma560::reflection::use_level(level);
  Eigen::MatrixXd all(function(0.0).size(), 60);
  for (int i = 0; i < 60; ++i) all.col(i) = function(0.1 * i).reshaped();
  puma560::reflection::use_level(Level::avx512);
  return all;
}

template <class Function>
void expect_another_rounding(Function function) {
  const Eigen::MatrixXd baseline = of_level(Level::baseline, function), avx2 = of_level(Level::avx2, function);
  EXPECT_LT((baseline - avx2).lpNorm<Eigen::Infinity>(), kOtherRounding);
  // Fused products are rounded only once, so among hundreds of numbers some differ.
  EXPECT_EQ(baseline != avx2, chooses());
}

TEST(Levels, TheBestIsChosenBeforeMain) {
  EXPECT_EQ(before_main, forces(0.3));
}

TEST(Levels, DifferByRoundingOnly) {
  expect_another_rounding([](double first) { return forces(first); });
}

TEST(Levels, AreThoseOfTransformsAndJacobians) {
  expect_another_rounding(
      [](double first) { return puma560::transforms::homogeneous::fr_base_X_fr_ee(angles(first)); });
  expect_another_rounding([](double first) { return puma560::jacobians::fr_base_J_fr_ee(angles(first)); });
}

// A level stays in use until another one is chosen, for all functions of that robot and for no other robot.
TEST(Levels, BelongToOneRobot) {
  const auto inertia = [] { return quadruped::joint_space_inertia(quadruped::JointState::Constant(0.6)).eval(); };
  const auto before = inertia();
  puma560::reflection::use_level(Level::baseline);
  const State low = forces(0.3);
  EXPECT_EQ(inertia(), before);
  EXPECT_EQ(forces(0.3), low);
  puma560::reflection::use_level(Level::avx512);
  EXPECT_EQ(forces(0.3), before_main);
}

TEST(Levels, HoldForSinglePrecision) {
  const auto q = angles(0.3).cast<float>().eval();
  const puma560::f32::JointState ones = puma560::f32::JointState::Ones();
  puma560::reflection::use_level(Level::baseline);
  const auto low = puma560::f32::inverse_dynamics(q, ones, ones);
  puma560::reflection::use_level(Level::avx512);
  EXPECT_LT((puma560::f32::inverse_dynamics(q, ones, ones) - low).lpNorm<Eigen::Infinity>(), 1e-3F);
}

// The library's initialisation runs when it is loaded, and it has kernels of its own.
TEST(Levels, AreChosenInASharedLibrary) {
  void* library = dlopen(SHARED_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(library, nullptr) << dlerror();
  const auto forces_of_library =
      reinterpret_cast<void (*)(const double*, double*)>(dlsym(library, "puma560_joint_forces"));
  ASSERT_NE(forces_of_library, nullptr);
  State tau;
  forces_of_library(angles(0.3).data(), tau.data());
  EXPECT_EQ(tau, before_main);
  dlclose(library);
}

}  // namespace
