// The project's quadruped with dual numbers: its functions agree with the derivatives of one another.
#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <random>

#include "dual.h"
#include "quadruped/kernel/accelerations.h"
#include "quadruped/kernel/inverse_dynamics.h"
#include "quadruped/kernel/jacobian_derivatives.h"
#include "quadruped/kernel/jacobians.h"
#include "quadruped/kernel/transforms.h"
#include "quadruped/kernel/velocities.h"

namespace robcogen::test {
namespace {

using autodiff::Dual;
using Complex = std::complex<double>;

constexpr std::size_t kJoints = 12;
constexpr double kRounding = 1e-12;  // relative; both derivatives are exact up to rounding
constexpr double kStep = 1e-30;      // of the complex step

std::array<double, kJoints> random_numbers(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> distribution(-1.5, 1.5);
  std::array<double, kJoints> values;
  for (double& v : values) v = distribution(random);
  return values;
}

// The linear columns of a Jacobian are the derivatives of the position.
TEST(RobotsAutodiff, JacobianIsTheDerivativeOfTheTransform) {
  const std::array<double, kJoints> q = random_numbers(1);
  std::array<double, 6 * 3> J;
  quadruped::kernel::fr_trunk_J_fr_LF_foot(q.data(), J.data());
  for (std::size_t joint = 0; joint < 3; ++joint) {
    std::array<Dual, kJoints> dual;
    for (std::size_t k = 0; k < kJoints; ++k) dual[k] = Dual(q[k], k == joint ? 1 : 0);
    std::array<Dual, 16> X;
    quadruped::kernel::homogeneous_fr_trunk_X_fr_LF_foot(dual.data(), X.data());
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(X[12 + axis].derivative, J[6 * joint + 3 + axis], kRounding) << "joint " << joint;
  }
}

// Derivatives along a motion q + qd t, qd + qdd t.
TEST(RobotsAutodiff, DerivativesByTime) {
  const std::array<double, kJoints> q = random_numbers(8), qd = random_numbers(9), qdd = random_numbers(10);
  std::array<Dual, kJoints> moving, speeding;
  for (std::size_t k = 0; k < kJoints; ++k) {
    moving[k] = Dual(q[k], qd[k]);
    speeding[k] = Dual(qd[k], qdd[k]);
  }
  std::array<Dual, 6 * 3> J;
  std::array<Dual, 6> V;
  quadruped::kernel::fr_trunk_J_fr_LF_foot(moving.data(), J.data());
  quadruped::kernel::fr_trunk_V_fr_LF_foot(moving.data(), speeding.data(), V.data());

  std::array<double, 6 * 3> Jd;
  std::array<double, 6> Jd_qd, A;
  quadruped::kernel::fr_trunk_Jd_fr_LF_foot(q.data(), qd.data(), Jd.data());
  quadruped::kernel::fr_trunk_Jd_qd_fr_LF_foot(q.data(), qd.data(), Jd_qd.data());
  quadruped::kernel::fr_trunk_A_fr_LF_foot(q.data(), qd.data(), qdd.data(), A.data());
  for (std::size_t k = 0; k < Jd.size(); ++k) EXPECT_NEAR(Jd[k], J[k].derivative, kRounding);
  for (std::size_t row = 0; row < 6; ++row) {
    EXPECT_NEAR(A[row], V[row].derivative, kRounding);
    // The columns belong to the first three joints.
    double sum = 0;
    for (std::size_t joint = 0; joint < 3; ++joint) sum += J[6 * joint + row].derivative * qd[joint];
    EXPECT_NEAR(Jd_qd[row], sum, kRounding);
  }
}

// A directional derivative of inverse dynamics with a floating base, by dual numbers and by a complex step.
TEST(RobotsAutodiff, InverseDynamics) {
  const std::array<double, kJoints> point[3] = {random_numbers(2), random_numbers(3), random_numbers(4)};
  const std::array<double, kJoints> direction[3] = {random_numbers(5), random_numbers(6), random_numbers(7)};
  const auto run = [&](const auto& number) {
    using Scalar = decltype(number(0.0, 0.0));
    std::array<Scalar, kJoints> x[3], tau;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < kJoints; ++k) x[i][k] = number(point[i][k], direction[i][k]);
    std::array<Scalar, 6> velocity, acceleration;
    for (std::size_t k = 0; k < 6; ++k) velocity[k] = number(point[0][k], direction[2][k]);
    const std::array<Scalar, 3> gravity{number(0.5, 0), number(0, 1), number(-9.7, 0)};
    quadruped::kernel::inverse_dynamics(
        x[0].data(), x[1].data(), x[2].data(), velocity.data(), gravity.data(), tau.data(), acceleration.data());
    return tau;
  };
  const auto dual = run([](double value, double derivative) { return Dual(value, derivative); });
  const auto complex = run([](double value, double derivative) { return Complex(value, kStep * derivative); });
  for (std::size_t k = 0; k < kJoints; ++k)
    EXPECT_NEAR(complex[k].imag() / kStep, dual[k].derivative, kRounding * (1 + std::abs(dual[k].derivative)));
}

}  // namespace
}  // namespace robcogen::test
