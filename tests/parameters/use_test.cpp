// Parameters with other scalars, in generic code, and with code that a compiler must refuse.
#include <everywhere_fixed/everywhere_fixed.h>
#include <everywhere_fixed/kernel/bias_forces.h>
#include <everywhere_fixed/kernel/parameters.h>
#include <everywhere_floating/everywhere_floating.h>
#include <everywhere_undeclared/everywhere_undeclared.h>
#include <gtest/gtest.h>
#include <hyl/hyl.h>
#include <hyl_parametric/hyl_parametric.h>

#include "../codegen/dual.h"
#include "robcogen/concepts.h"
#include "robcogen/generic/computed_torque.h"
#include "values.h"

namespace robcogen::test::use_test {
namespace {

static_assert(FixedBaseRobot<hyl_parametric::Robot> && FixedBaseRobot<everywhere_fixed::Robot>);
static_assert(FloatingBaseRobot<everywhere_floating::Robot>);
static_assert(std::is_empty_v<hyl::Robot> && !std::is_empty_v<hyl_parametric::Robot>);

// A parameter without a default has no value that could be used instead.
static_assert(std::is_default_constructible_v<everywhere_fixed::Parameters<>>);
static_assert(!std::is_default_constructible_v<everywhere_undeclared::Parameters<>>);
static_assert(!std::is_default_constructible_v<everywhere_undeclared::Robot>);
static_assert(std::is_constructible_v<everywhere_undeclared::Parameters<>, everywhere_undeclared::ParameterValues>);

// Updates can be called in a loop that must not throw.
static_assert(noexcept(std::declval<hyl_parametric::Parameters<>&>().update(hyl_parametric::ParameterValues())));
static_assert(noexcept(std::declval<const hyl_parametric::DynamicsParameters&>().get_slider_mass()));
static_assert(std::is_base_of_v<hyl_parametric::KinematicsParameters, hyl_parametric::ParameterValues>);
static_assert(std::is_base_of_v<hyl_parametric::DynamicsParameters, hyl_parametric::ParameterValues>);
static_assert(std::is_trivially_copyable_v<hyl_parametric::Parameters<>>);

template <class... Arguments>
constexpr bool kGravityForces = requires(const Arguments&... a) {
  hyl_parametric::gravity_forces(a...);
};

static_assert(kGravityForces<hyl_parametric::Parameters<>, Eigen::Vector3d>);
static_assert(!kGravityForces<Eigen::Vector3d>);
static_assert(!kGravityForces<hyl_parametric::Parameters<float>, Eigen::Vector3d>);
static_assert(!kGravityForces<everywhere_fixed::Parameters<>, Eigen::Vector3d>);
static_assert(!kGravityForces<hyl_parametric::ParameterValues, Eigen::Vector3d>);

TEST(Use, ValuesThatWereNotGivenAreNoNumbers) {
  const everywhere_undeclared::ParameterValues values;
  EXPECT_TRUE(std::isnan(values.trunk_mass) && std::isnan(values.upper));
  const everywhere_undeclared::Parameters<> given(other_values<everywhere_undeclared::ParameterValues>());
  const everywhere_fixed::Parameters<> expected(other_values<everywhere_fixed::ParameterValues>());
  const Eigen::Vector4d q(0.3, -0.7, 0.2, 1.1);
  // The two libraries may be compiled for different processors, and then round differently.
  EXPECT_TRUE(
      everywhere_undeclared::gravity_forces(given, q).isApprox(everywhere_fixed::gravity_forces(expected, q), 1e-14));
}

TEST(Use, SinglePrecisionRoundsTheCacheOnce) {
  const auto values = other_values<everywhere_fixed::ParameterValues>();
  const everywhere_fixed::Parameters<double> p(values);
  const everywhere_fixed::Parameters<float> f(values);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(f.data()[i], static_cast<float>(p.data()[i]));
  const Eigen::Vector4d q(0.3, -0.7, 0.2, 1.1);
  const Eigen::Vector4d tau = everywhere_fixed::gravity_forces(p, q);
  const Eigen::Vector4f single = everywhere_fixed::f32::gravity_forces(f, q.cast<float>());
  EXPECT_TRUE(single.cast<double>().isApprox(tau, 1e-5)) << single.transpose() << "; " << tau.transpose();
}

// Sensitivities: the kernels of the updates accept any scalar, and with dual numbers they propagate derivatives.
TEST(Use, DerivativesWithRespectToParameters) {
  using namespace everywhere_fixed;
  using autodiff::Dual;
  const ParameterArray values = Parameters<>().array();
  const JointState q(0.3, -0.7, 0.2, 1.1);
  constexpr double kStep = 1e-5;
  constexpr double kTolerance = 1e-7;  // truncation of a central difference of forces of tens of newtons
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::array<Dual, kParameterNames.size()> parameters;
    for (std::size_t i = 0; i < values.size(); ++i) parameters[i] = Dual(values[i], i == k ? 1 : 0);
    std::array<Dual, Parameters<>::size()> cache;
    kernel::update(parameters.data(), cache.data());
    const Dual at[] = {Dual(q(0)), Dual(q(1)), Dual(q(2)), Dual(q(3))};
    Dual tau[4];
    kernel::gravity_forces(cache.data(), at, tau);

    ParameterArray more = values, less = values;
    more[k] += kStep;
    less[k] -= kStep;
    const JointState slope =
        (gravity_forces(Parameters<>(more), q) - gravity_forces(Parameters<>(less), q)) / (2 * kStep);
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(tau[j].derivative, slope(j), kTolerance) << kParameterNames[k] << " " << j;
  }
}

}  // namespace
}  // namespace robcogen::test::use_test
