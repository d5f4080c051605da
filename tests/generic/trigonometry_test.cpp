// Functions that take sines and cosines in place of joint positions, selected by their types: in double and single
// precision, for robots with both kinds of bases, constant and with parameters.
#include <hyl_parametric/hyl_parametric.h>

#include "robcogen/reference/check_trigonometry.h"
#include "robots.h"

namespace robcogen::test::trigonometry_test {
namespace {

template <class Matrix>
auto largest(const Matrix& m) {
  return m.size() == 0 ? typename Matrix::Scalar(0) : m.cwiseAbs().maxCoeff();
}

// Sines and cosines of fewer than four angles may come from another library: they differ by an ulp, which the function
// magnifies.
template <class Matrix>
void expect_close(const Matrix& found, const Matrix& expected, const char* what) {
  using Scalar = typename Matrix::Scalar;
  const Scalar tolerance = 1000 * std::numeric_limits<Scalar>::epsilon();
  EXPECT_LE(largest(Matrix(found - expected)), tolerance * largest(expected)) << what;
}

template <class R>
class Trigonometry : public ::testing::Test {};

#if ROBCOGEN_TEST_EVERYTHING
using Robots = ::testing::Types<
    hyl::Robot,
    puma560::Robot,
    quadruped::Robot,
    torso::Robot,
    hyl::f32::Robot,
    puma560::f32::Robot,
    quadruped::f32::Robot>;
#else
using Robots = ::testing::Types<hyl::Robot, quadruped::Robot, puma560::f32::Robot>;
#endif
TYPED_TEST_SUITE(Trigonometry, Robots);

template <class R>
typename R::JointState joints(unsigned seed) {
  std::mt19937_64 engine(seed);
  typename R::JointState result;
  for (auto& x : result) x = static_cast<typename R::Scalar>(reference::uniform(engine, 2));
  return result;
}

// Rotates one joint after the other by many turns: sines and cosines in lanes are for small angles only.
TYPED_TEST(Trigonometry, LargeAnglesAreNoOthers) {
  using R = TypeParam;
  using Scalar = typename R::Scalar;
  const auto usual = joints<R>(1);
  for (Eigen::Index k = 0; k < usual.size(); ++k) {
    auto q = usual;
    q[k] = Scalar(1e6);
    const typename R::JointTrigonometry given(q, q.array().sin(), q.array().cos());
    expect_close(R::joint_space_inertia(q), R::joint_space_inertia(given), "inertia matrix");
    if constexpr (R::kFloatingBase) {  // with a fixed base the first joint has no effect
      q[k] = std::numeric_limits<Scalar>::quiet_NaN();
      EXPECT_TRUE(R::joint_space_inertia(q).hasNaN()) << k;
    }
  }
}

TYPED_TEST(Trigonometry, OfOneStateServesAllFunctions) {
  using R = TypeParam;
  using Vector3 = typename R::Vector3;
  const auto q = joints<R>(1), qd = joints<R>(2), qdd = joints<R>(3);
  const typename R::JointTrigonometry at(q), given(q, q.array().sin(), q.array().cos());
  EXPECT_EQ(at.q(), q);
  for (const auto& known : {at, given}) {
    expect_close(R::joint_space_inertia(known), R::joint_space_inertia(q), "inertia matrix");
    expect_close(R::joint_space_inertia_factor(known).L(), R::joint_space_inertia_factor(q).L(), "factor");
    expect_close(R::center_of_mass(known), R::center_of_mass(q), "centre of mass");
    expect_close(R::centroidal_momentum_matrix(known), R::centroidal_momentum_matrix(q), "momentum");
    if constexpr (R::kFloatingBase) {
      const typename R::Twist v(Vector3(1, 2, 3), Vector3(0, -1, 1));
      const typename R::Gravity gravity(1, -3, -9);
      expect_close(R::bias_forces(known, qd, v, gravity).tau, R::bias_forces(q, qd, v, gravity).tau, "bias");
      expect_close(
          R::inverse_dynamics(known, qd, qdd, v, gravity).tau, R::inverse_dynamics(q, qd, qdd, v, gravity).tau, "tau");
      expect_close(
          R::forward_dynamics(known, qd, qdd, v, gravity).qdd, R::forward_dynamics(q, qd, qdd, v, gravity).qdd, "qdd");
    } else {
      typename R::LinkWrenches external;
      external[static_cast<int>(R::kLinkCount) - 1] = typename R::Wrench(Vector3(1, 2, 3), Vector3(4, 5, 6));
      const typename R::Gravity gravity(1, -3, -9);
      expect_close(R::bias_forces(known, qd), R::bias_forces(q, qd), "bias");
      expect_close(R::inverse_dynamics(known, qd, qdd), R::inverse_dynamics(q, qd, qdd), "tau");
      expect_close(
          R::inverse_dynamics(known, qd, qdd, gravity), R::inverse_dynamics(q, qd, qdd, gravity), "tau under gravity");
      expect_close(
          R::inverse_dynamics(known, qd, qdd, external), R::inverse_dynamics(q, qd, qdd, external), "tau under load");
      expect_close(R::forward_dynamics(known, qd, qdd), R::forward_dynamics(q, qd, qdd), "qdd");
    }
  }
}

// Sines and cosines are computed for all joints together, as in functions that read all joints: the same to the last
// bit.
template <class R>
class TrigonometryOfMany : public ::testing::Test {};

#if ROBCOGEN_TEST_EVERYTHING
using RobotsOfManyJoints =
    ::testing::Types<puma560::Robot, quadruped::Robot, torso::Robot, puma560::f32::Robot, quadruped::f32::Robot>;
#else
using RobotsOfManyJoints = ::testing::Types<quadruped::Robot, puma560::f32::Robot>;
#endif
TYPED_TEST_SUITE(TrigonometryOfMany, RobotsOfManyJoints);

TYPED_TEST(TrigonometryOfMany, ChangesNoBitWhereFunctionsReadAllJoints) {
  using R = TypeParam;
  const auto q = joints<R>(4);
  const typename R::JointTrigonometry at(q);
  const auto H = R::joint_space_inertia(q);
  const auto inverse = R::joint_space_inertia_factor(q).inverse();
#if defined(__clang__)  // fuses the last product of a sine with what reads it, where it compiles both together
  constexpr auto kEpsilon = std::numeric_limits<typename R::Scalar>::epsilon();
  EXPECT_TRUE(R::joint_space_inertia(at).isApprox(H, 8 * kEpsilon));
  EXPECT_TRUE(R::joint_space_inertia_factor(at).inverse().isApprox(inverse, 64 * kEpsilon));
#else
  EXPECT_EQ(R::joint_space_inertia(at), H);
  EXPECT_EQ(R::joint_space_inertia_factor(at).inverse(), inverse);
#endif
}

TYPED_TEST(Trigonometry, HoldsSinesAndCosinesOfTheJoints) {
  using R = TypeParam;
  using Scalar = typename R::Scalar;
  const auto q = joints<R>(5);
  const typename R::JointTrigonometry at(q);
  const int first = R::kDof == hyl::kDof ? 1 : 0;  // the first joint of HyL slides
  for (int k = first; k < R::kDof; ++k) {
    EXPECT_NEAR(at.sin_q()[k], std::sin(q[k]), std::numeric_limits<Scalar>::epsilon());
    EXPECT_NEAR(at.cos_q()[k], std::cos(q[k]), std::numeric_limits<Scalar>::epsilon());
  }
}

TEST(Trigonometry, JointsThatSlideKeepTheirPosition) {
  const hyl::JointState q(0.7, 0.3, -0.4);
  const hyl::JointTrigonometry at(q);
  EXPECT_EQ(at.sin_q()[0], 0);
  EXPECT_EQ(at.cos_q()[0], 1);
  const Eigen::Matrix4d X = hyl::transforms::homogeneous::fr_base_X_fr_foot(at);
  EXPECT_TRUE(X.isApprox(hyl::transforms::homogeneous::fr_base_X_fr_foot(q), 1e-15));
  EXPECT_FALSE(X.isApprox(hyl::transforms::homogeneous::fr_base_X_fr_foot(hyl::JointState(0, 0.3, -0.4)), 1e-3));
  EXPECT_TRUE(hyl::jacobians::fr_base_J_fr_foot(at).isApprox(hyl::jacobians::fr_base_J_fr_foot(q), 1e-15));
}

TEST(Trigonometry, ARobotWithParametersTakesThemFirst) {
  const hyl_parametric::Robot robot{};
  const hyl_parametric::JointState q(0.7, 0.3, -0.4), qd(1, 2, 3), qdd(3, 2, 1);
  const hyl_parametric::JointTrigonometry at(robot.parameters, q);
  EXPECT_TRUE(robot.inverse_dynamics(at, qd, qdd).isApprox(robot.inverse_dynamics(q, qd, qdd), 1e-14));
  EXPECT_TRUE(hyl_parametric::inverse_dynamics(robot.parameters, at, qd, qdd)
                  .isApprox(robot.inverse_dynamics(q, qd, qdd), 1e-14));
}

// The self-check finds two swapped sines in every function that reads at least four.
using Core = void (*)(const double*, const double*, const double*, double*) noexcept;
Core right = nullptr;
void swapped(const double* in, const double* sin_q, const double* cos_q, double* out) noexcept {
  std::array<double, puma560::kDof> sine;
  std::copy_n(sin_q, sine.size(), sine.begin());
  std::swap(sine[1], sine[3]);
  right(in, sine.data(), cos_q, out);
}

TEST(Trigonometry, TheSelfCheckFindsSwappedSines) {
  int functions = 0;
  for (reflection::Function f : puma560::reflection::robot.functions) {
    if (f.call_core == nullptr || f.count.sincos < 4) continue;
    for (const bool is_swapped : {false, true}) {
      right = f.call_core;
      reflection::Function checked = f;
      if (is_swapped) checked.call_core = swapped;
      std::mt19937_64 engine(6);
      reference::Checks checks;
      reference::check_core(puma560::reflection::robot, checked, {}, engine, 5, checks);
      EXPECT_EQ(checks.failures(), is_swapped ? 2 : 0) << f.name << "\n" << checks.report();
    }
    ++functions;
  }
  EXPECT_GE(functions, 10);
}

// A state of another type, precision or position in the list does not compile.
template <class... Arguments>
constexpr bool kInverseDynamics = requires(const Arguments&... a) {
  puma560::inverse_dynamics(a...);
};

TEST(Trigonometry, WhatDoesNotCompile) {
  using At = puma560::JointTrigonometry;
  using State = puma560::JointState;
  static_assert(kInverseDynamics<At, State, State> && kInverseDynamics<State, State, State>);
  static_assert(!kInverseDynamics<State, At, State> && !kInverseDynamics<State, State, At>);
  static_assert(!kInverseDynamics<hyl::JointTrigonometry, State, State>);
  static_assert(!kInverseDynamics<puma560::f32::JointTrigonometry, State, State>);
  static_assert(!std::is_convertible_v<State, At> && std::is_constructible_v<At, State>);
  static_assert(!std::is_default_constructible_v<At> && !std::is_constructible_v<At, State, State>);
  static_assert(!std::is_constructible_v<hyl_parametric::JointTrigonometry, hyl_parametric::JointState>);
  static_assert(std::is_nothrow_constructible_v<At, State>);
  static_assert(noexcept(puma560::joint_space_inertia(std::declval<const At&>())));
}

}  // namespace
}  // namespace robcogen::test::trigonometry_test
