#include "swing_up.h"

#include <cmath>

namespace optimal_control {
namespace {

using Force = Eigen::Matrix<double, 1, 1>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kCartPoleStep = 0.01, kPumaStep = 0.005;      // s
constexpr std::size_t kCartPoleSteps = 400, kPumaSteps = 400;  // 4 s, 2 s

const Force kCartLimit(5);  // N
// Torque limits in N m. Holding the arm out straight takes 37 N m at the shoulder and 9 N m at the elbow.
const Vector6 kPumaLimits = (Vector6() << 20, 20, 8, 2, 2, 2).finished();

constexpr int kMaxIterations = 500;
constexpr double kTolerance = 1e-7;

template <int n, int m>
Trajectory<n, m> starting(
    const Eigen::Matrix<double, n, 1>& x,
    const Eigen::Matrix<double, m, 1>& u,
    std::size_t steps) {
  Trajectory<n, m> start;
  start.x = {x};
  start.u.assign(steps, u);
  return start;
}

}  // namespace

Eigen::Vector4d cart_pole_step(const Eigen::Vector4d& x, const Force& u, Linearisation<4, 1>* linearisation) {
  static const auto step = step_of<2, 1>(
      kCartPoleStep, kCartLimit,
      [](const auto& q, const auto& qd, const auto& tau) { return cart_pole::forward_dynamics(q, qd, tau); },
      [](const auto& q, const auto& qd, const auto& tau) {
        return cart_pole::forward_dynamics_derivatives(q, qd, tau);
      });
  return step(x, u, linearisation);
}

Eigen::Matrix<double, 12, 1> puma_step(
    const Eigen::Matrix<double, 12, 1>& x,
    const Vector6& u,
    Linearisation<12, 6>* linearisation) {
  static const auto step = step_of<6, 6>(
      kPumaStep, kPumaLimits,
      [](const auto& q, const auto& qd, const auto& tau) { return puma560_control::forward_dynamics(q, qd, tau); },
      [](const auto& q, const auto& qd, const auto& tau) {
        return puma560_control::forward_dynamics_derivatives(q, qd, tau);
      });
  return step(x, u, linearisation);
}

CartPoleMotion swing_up_cart_pole() {
  Weights<4, 1> weights;
  weights.goal << 0, M_PI, 0, 0;
  weights.state << 0.01, 0.01, 0.001, 0.001;
  weights.end << 1000, 1000, 100, 100;
  weights.input << 0.01;
  IterativeLqr<4, 1, decltype(cart_pole_step)> search(
      cart_pole_step, weights, starting<4, 1>(Eigen::Vector4d::Zero(), Force(0.01), kCartPoleSteps));
  return {kCartPoleStep, kCartLimit, search.solve(kMaxIterations, kTolerance)};
}

PumaMotion swing_up_puma() {
  Eigen::Matrix<double, 12, 1> hanging = Eigen::Matrix<double, 12, 1>::Zero();
  hanging[1] = hanging[2] = M_PI / 2;
  Weights<12, 6> weights;
  weights.goal = hanging;
  weights.goal[1] = -M_PI / 2;
  weights.state << Vector6::Constant(0.01), Vector6::Constant(0.001);
  weights.end << Vector6::Constant(1000), Vector6::Constant(100);
  weights.input.setConstant(0.01);
  IterativeLqr<12, 6, decltype(puma_step)> search(
      puma_step, weights, starting<12, 6>(hanging, Vector6::Constant(0.01), kPumaSteps));
  return {kPumaStep, kPumaLimits, search.solve(kMaxIterations, kTolerance)};
}

}  // namespace optimal_control
