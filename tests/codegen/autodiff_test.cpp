// Kernels with scalar types of the user: dual numbers and complex numbers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "cart_pole/kernel/forward_dynamics.h"
#include "cart_pole/kernel/inverse_dynamics.h"
#include "dual.h"
#include "legs/floating/hopper/kernel/bias_forces.h"

namespace robcogen::test::autodiff_test {
namespace {

using autodiff::Dual;
using Complex = std::complex<double>;

constexpr double kRounding = 1e-13;  // both derivatives are exact up to rounding
constexpr double kStep = 1e-30;      // of the complex step: no difference is formed, so no digit is lost

template <class Scalar>
struct State {
  std::array<Scalar, 2> q{Scalar(0.3), Scalar(-0.8)}, qd{Scalar(0.7), Scalar(1.1)}, x{Scalar(-0.4), Scalar(0.9)};
  std::array<Scalar, 3> gravity{Scalar(0.5), Scalar(-0.1), Scalar(-9.0)};

  // The k-th number of the state.
  Scalar& operator[](std::size_t k) { return k < 2 ? q[k] : k < 4 ? qd[k - 2] : k < 6 ? x[k - 4] : gravity[k - 6]; }
};

template <class Scalar>
std::array<Scalar, 2> inverse(const State<Scalar>& s) {
  std::array<Scalar, 2> tau;
  cart_pole::kernel::inverse_dynamics_gravity(s.q.data(), s.qd.data(), s.x.data(), s.gravity.data(), tau.data());
  return tau;
}

template <class Scalar>
std::array<Scalar, 2> forward(const State<Scalar>& s) {
  std::array<Scalar, 2> qdd;
  cart_pole::kernel::forward_dynamics_gravity(s.q.data(), s.qd.data(), s.x.data(), s.gravity.data(), qdd.data());
  return qdd;
}

template <class Function>
void expect_same_derivatives(const Function& function) {
  for (std::size_t k = 0; k < 9; ++k) {
    SCOPED_TRACE("derivative by number " + std::to_string(k));
    State<Dual> dual;
    dual[k].derivative = 1;
    State<Complex> complex;
    complex[k] += Complex(0, kStep);
    State<double> up, down;
    up[k] += 1e-6;
    down[k] -= 1e-6;
    const auto by_dual = function(dual);
    const auto by_complex = function(complex);
    const auto above = function(up), below = function(down);
    for (std::size_t i = 0; i < 2; ++i) {
      const double exact = by_dual[i].derivative;
      EXPECT_NEAR(by_complex[i].imag() / kStep, exact, kRounding * (1 + std::abs(exact)));
      EXPECT_NEAR((above[i] - below[i]) / 2e-6, exact, 1e-7 * (1 + std::abs(exact)));
      EXPECT_NEAR(by_dual[i].value, function(State<double>())[i], kRounding * (1 + std::abs(by_dual[i].value)));
    }
  }
}

TEST(Autodiff, InverseDynamics) {
  expect_same_derivatives([](const auto& state) { return inverse(state); });
}

TEST(Autodiff, ForwardDynamics) {
  expect_same_derivatives([](const auto& state) { return forward(state); });
}

// Rounding to double anywhere in a kernel would leave errors of about 1e-16.
TEST(Autodiff, LongDoubleKeepsItsDigits) {
  const State<long double> given;
  State<long double> state = given;
  state.x = inverse(given);
  const std::array<long double, 2> back = forward(state);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(std::abs(back[i] - given.x[i]), 5e-17L);
}

TEST(Autodiff, FloatingBaseKernels) {
  std::array<Dual, 1> q{Dual(0.2, 1)}, qd{Dual(0.3)}, tau;
  std::array<Dual, 6> velocity{}, wrench;
  legs::floating::hopper::kernel::coriolis_forces(q.data(), qd.data(), velocity.data(), tau.data(), wrench.data());
  EXPECT_TRUE(std::isfinite(tau[0].derivative));
  EXPECT_NE(tau[0].derivative, 0);
}

}  // namespace
}  // namespace robcogen::test::autodiff_test
