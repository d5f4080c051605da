// The programs of robots/optimal_control: motions that reach their goals, linearisations compared with differences, and
// a quadruped that stands.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "picture.h"
#include "stand.h"
#include "swing_up.h"

namespace optimal_control {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

const CartPoleMotion& cart_pole_motion() {
  static const CartPoleMotion motion = swing_up_cart_pole();
  return motion;
}

const PumaMotion& puma_motion() {
  static const PumaMotion motion = swing_up_puma();
  return motion;
}

// Compares a linearisation with central differences of a step.
template <int n, int m, class Step>
void expect_linearisation(
    const Step& step,
    const Eigen::Matrix<double, n, 1>& x,
    const Eigen::Matrix<double, m, 1>& u) {
  constexpr double h = 1e-5, kNear = 1e-7;
  Linearisation<n, m> found;
  const Eigen::Matrix<double, n, 1> next = step(x, u, &found);
  EXPECT_LT((next - step(x, u, nullptr)).norm(), 1e-12 * (1 + next.norm()));
  for (int k = 0; k < n; ++k) {
    Eigen::Matrix<double, n, 1> d = Eigen::Matrix<double, n, 1>::Unit(k) * h;
    const Eigen::Matrix<double, n, 1> column = (step(x + d, u, nullptr) - step(x - d, u, nullptr)) / (2 * h);
    EXPECT_LT((column - found.A.col(k)).norm(), kNear) << k;
  }
  for (int k = 0; k < m; ++k) {
    Eigen::Matrix<double, m, 1> d = Eigen::Matrix<double, m, 1>::Unit(k) * h;
    const Eigen::Matrix<double, n, 1> column = (step(x, u + d, nullptr) - step(x, u - d, nullptr)) / (2 * h);
    EXPECT_LT((column - found.B.col(k)).norm(), kNear * (1 + found.B.col(k).norm())) << k;
  }
}

TEST(SwingUp, StepsAreLinearisedAsTheyMove) {
  expect_linearisation<4, 1>(cart_pole_step, Eigen::Vector4d(0.2, 1.1, -0.5, 2), Eigen::Matrix<double, 1, 1>(0.4));
  Eigen::Matrix<double, 12, 1> x;
  x << 0.3, -0.8, 1.2, 0.4, -0.6, 0.2, 0.5, 1, -1, 0.3, -0.7, 0.9;
  expect_linearisation<12, 6>(puma_step, x, Vector6(Vector6::LinSpaced(-0.6, 0.7)));
}

TEST(SwingUp, CartPoleStandsUp) {
  const auto& t = cart_pole_motion().trajectory;
  EXPECT_TRUE(t.is_converged);
  EXPECT_LT(t.costs.back(), 25);
  for (std::size_t i = 1; i < t.costs.size(); ++i) EXPECT_LT(t.costs[i], t.costs[i - 1]);
  EXPECT_NEAR(t.x.back()[1], M_PI, 0.01);
  EXPECT_LT(t.x.back().tail<2>().norm(), 0.05);
  EXPECT_NEAR(t.x.back()[0], 0, 0.01);
  // The tip is above the cart in the end, and was below it.
  const auto height = [](const Eigen::Vector4d& x) {
    return cart_pole::transforms::homogeneous::fr_base_X_fr_tip(x.head<2>())(2, 3);
  };
  EXPECT_NEAR(height(t.x.front()), -1, 1e-9);
  EXPECT_NEAR(height(t.x.back()), 1, 1e-3);
}

// The energy of the motion is the work of the cart's drive: the dynamics are those of the robot.
TEST(SwingUp, WorkBecomesEnergy) {
  const CartPoleMotion& m = cart_pole_motion();
  const auto energy = [](const Eigen::Vector4d& x) {
    return cart_pole::kinetic_energy(x.head<2>(), x.tail<2>()) + cart_pole::potential_energy(x.head<2>());
  };
  double work = 0;
  for (std::size_t k = 0; k < m.trajectory.u.size(); ++k)
    work += m.force(k)[0] * (m.trajectory.x[k + 1][0] - m.trajectory.x[k][0]);
  EXPECT_NEAR(work, 2 * 0.3 * 9.81 * 0.5, 0.3);  // the rod is raised by a metre; semi-implicit Euler, 10 ms
  EXPECT_NEAR(energy(m.trajectory.x.back()) - energy(m.trajectory.x.front()), 2 * 0.3 * 9.81 * 0.5, 0.01);
}

TEST(SwingUp, WeakArmStandsUp) {
  const PumaMotion& m = puma_motion();
  const auto& t = m.trajectory;
  EXPECT_TRUE(t.is_converged);
  EXPECT_LT(t.costs.back(), 25);
  Vector6 goal = Vector6::Zero();
  goal[1] = -M_PI / 2;
  goal[2] = M_PI / 2;
  EXPECT_LT((t.x.back().head<6>() - goal).norm(), 0.01);
  EXPECT_LT(t.x.back().tail<6>().norm(), 0.02);
  for (std::size_t k = 0; k < t.u.size(); ++k) {
    const Vector6 share = m.force(k).cwiseQuotient(m.limits);
    EXPECT_LE(share.cwiseAbs().maxCoeff(), 1) << k;
  }
  // The arm is weak: held out, it falls with full torque at the shoulder.
  Vector6 full = Vector6::Zero();
  full.head<2>() << 0, -m.limits[1];
  EXPECT_GT(puma560_control::forward_dynamics(Vector6::Zero(), Vector6::Zero(), full)[1], 0);
}

TEST(SwingUp, FeedbackLeadsBackToThePath) {
  const auto& t = puma_motion().trajectory;
  const auto miss = [&](bool is_fed_back) {
    Eigen::Matrix<double, 12, 1> x = t.x.front();
    x[1] += 0.02;
    for (std::size_t k = 0; k < t.u.size(); ++k) {
      Vector6 u = t.u[k];
      if (is_fed_back) u += t.feedback[k] * (x - t.x[k]);
      x = puma_step(x, u, nullptr);
    }
    return (x - t.x.back()).head<6>().norm();
  };
  EXPECT_LT(miss(true), 0.02);
  EXPECT_GT(miss(false), 2 * miss(true));
}

TEST(SwingUp, PicturesShowFiguresAndForces) {
  for (const std::string& text : {picture(cart_pole_motion()), picture(puma_motion())}) {
    EXPECT_EQ(text.rfind("</svg>\n"), text.size() - 7);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
    EXPECT_GT(text.size(), 5000U);
  }
}

TEST(Standing, IsAnUnstableEquilibrium) {
  const Standing s = standing(0.6);
  constexpr double kMass = 60.96 + 4 * (2.93 + 2.638 + 0.881);
  double weight = 0;
  for (int foot = 0; foot < 4; ++foot) weight += s.forces[3 * foot + 2];
  EXPECT_NEAR(weight, kMass * 9.81, 1e-9 * weight);
  EXPECT_GT(s.rate.eigenvalues().real().maxCoeff(), 1);
  // Without the regulator the robot falls.
  const auto fallen = push(s, Matrix12::Zero(), Vector6(Vector6::Unit(3) * 0.01), 1);
  EXPECT_GT(fallen.back().state.head<6>().norm(), 0.1);
}

TEST(Standing, RegulatedEigenvaluesAreInsideTheUnitCircle) {
  const Standing s = standing(0.6);
  const Matrix12 K = regulator(s);
  EXPECT_LT(closed_loop_moduli(s, K).maxCoeff(), 0.995);
  EXPECT_GT(s.A.eigenvalues().cwiseAbs().maxCoeff(), 1.01);
  // With one input and one state, the gain follows from a quadratic equation.
  Matrix12 A = Matrix12::Zero(), B = Matrix12::Zero();
  A(0, 0) = 1.5;
  B(0, 0) = 0.5;
  const Matrix12 k = regulator(A, B, Vector12::Ones(), 1);
  // P = 1 + a^2 P / (1 + b^2 P): b^2 P^2 + (1 - a^2 - b^2) P - 1 = 0
  const double b = 0.25, c = 1 - 2.25 - b, P = (-c + std::sqrt(c * c + 4 * b)) / (2 * b);
  EXPECT_NEAR(k(0, 0), -0.5 * P * 1.5 / (1 + 0.25 * P), 1e-12);
}

// The linear model predicts a small push of the whole robot, whose feet are held by contact forces.
TEST(Standing, LinearModelPredictsTheRobot) {
  const Standing s = standing(0.6);
  const Matrix12 K = regulator(s);
  constexpr int kSteps = 100;
  for (int k = 0; k < 6; ++k) {
    const auto instants = push(s, K, Vector6(Vector6::Unit(k) * 1e-4), kSteps * kControlStep);
    Vector12 x = instants.front().state;
    for (int i = 0; i < kSteps; ++i) x = ((s.A + s.B * K) * x).eval();
    // The robot is simulated by first-order steps of 0.2 ms.
    EXPECT_LT((instants[kSteps].state - x).norm(), 0.03 * x.norm()) << k;
  }
}

TEST(Standing, PushesDecay) {
  const Standing s = standing(0.6);
  const auto instants = push(s, regulator(s), (Vector6() << 0, 0, 0, 0.1, 0.1, 0).finished(), 2);
  double most = 0;
  for (const Instant& i : instants) {
    most = std::max(most, i.state.head<6>().norm());
    EXPECT_GT(i.least_force, 0) << i.time;      // feet push, and do not pull
    EXPECT_LT(i.most_friction, 0.6) << i.time;  // and do not slip
  }
  EXPECT_GT(most, 1e-3);
  EXPECT_LT(instants.back().state.norm(), 1e-5);
  EXPECT_THROW(standing(0.9), std::domain_error);
}

}  // namespace
}  // namespace optimal_control
