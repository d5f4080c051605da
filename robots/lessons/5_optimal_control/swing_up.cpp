// A cart swings its pole up with a force that is too weak to lift it at once, and does so from many starting states.
#include <cart_pole/batch.h>
#include <cart_pole/cart_pole.h>
#include <ilqr.h>
#include <robcogen/parallel.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using cart_pole::JointState;  // RAIL (m), HINGE (rad): 0 is hanging, pi upright
using optimal_control::IterativeLqr, optimal_control::Linearisation, optimal_control::Trajectory,
    optimal_control::Weights;
using X = Eigen::Vector4d;  // q, qd
using U = Eigen::Matrix<double, 1, 1>;

constexpr double kStep = 0.01, kMaxForce = 5;  // s, N
constexpr int kSteps = 400;

// The force of an input, which may be any number: it is always within the limits.
double force(double u) {
  return kMaxForce * std::tanh(u);
}

// A step of semi-implicit Euler, qd' = qd + h qdd, q' = q + h qd', and its derivatives.
X step(const X& x, const U& u, Linearisation<4, 1>* linearisation) {
  const JointState q = x.head<2>(), qd = x.tail<2>(), tau(force(u[0]), 0);
  JointState qdd;
  if (linearisation) {
    const auto d = cart_pole::forward_dynamics_derivatives(q, qd, tau);
    qdd = d.qdd;
    Eigen::Matrix<double, 2, 4> qd_next;
    qd_next << kStep * d.d_q, kStep * d.d_qd;
    qd_next.rightCols<2>() += Eigen::Matrix2d::Identity();
    linearisation->A << kStep * qd_next, qd_next;
    linearisation->A.topLeftCorner<2, 2>() += Eigen::Matrix2d::Identity();
    const double slope = kMaxForce * (1 - std::tanh(u[0]) * std::tanh(u[0]));
    linearisation->B << kStep * kStep * slope * d.d_tau.col(0), kStep * slope * d.d_tau.col(0);
  } else {
    qdd = cart_pole::forward_dynamics(q, qd, tau);
  }
  X next;
  next.tail<2>() = qd + kStep * qdd;
  next.head<2>() = q + kStep * next.tail<2>();
  return next;
}

// The largest difference between the derivatives and finite differences of the step.
double error_of_derivatives() {
  const X x(0.2, 1.3, -0.5, 2.0);
  const U u(0.4);
  Linearisation<4, 1> d;
  step(x, u, &d);
  double error = 0;
  const double h = 1e-6;
  for (int k = 0; k < 4; ++k) {
    const X change = h * X::Unit(k);
    const X column = (step(x + change, u, nullptr) - step(x - change, u, nullptr)) / (2 * h);
    error = std::max(error, (column - d.A.col(k)).cwiseAbs().maxCoeff());
  }
  return error;
}

// Lets many carts follow the plan, each from a starting angle of its own, and returns the percentage that ends upright.
// Arrays hold the rails of a block of carts, then their hinges.
double percent_upright(const Trajectory<4, 1>& plan, int n, robcogen::batch::ThreadPool& pool) {
  using robcogen::batch::by_element;
  std::mt19937 engine(1);
  std::vector<double> start(static_cast<std::size_t>(n));
  for (double& angle : start) angle = static_cast<double>(engine()) * 0x1p-32 * 3 - 1.5;  // rad

  constexpr int kBlock = 256;
  std::atomic<int> upright = 0;
  pool((n + kBlock - 1) / kBlock, [&](std::ptrdiff_t block) {
    const std::ptrdiff_t first = block * kBlock, count = std::min<std::ptrdiff_t>(kBlock, n - first);
    double q[2 * kBlock] = {}, qd[2 * kBlock] = {}, tau[2 * kBlock] = {}, qdd[2 * kBlock];
    for (std::ptrdiff_t i = 0; i < count; ++i) q[kBlock + i] = start[static_cast<std::size_t>(first + i)];
    for (std::size_t k = 0; k < plan.u.size(); ++k) {
      for (std::ptrdiff_t i = 0; i < count; ++i) {
        const X error = X(q[i], q[kBlock + i], qd[i], qd[kBlock + i]) - plan.x[k];
        tau[i] = force(plan.u[k][0] + (plan.feedback[k] * error)[0]);
      }
      cart_pole::batch::forward_dynamics(
          count, by_element(q, kBlock), by_element(qd, kBlock), by_element(tau, kBlock), by_element(qdd, kBlock));
      for (int j = 0; j < 2 * kBlock; ++j) {
        qd[j] += kStep * qdd[j];
        q[j] += kStep * qd[j];
      }
    }
    for (std::ptrdiff_t i = 0; i < count; ++i)
      if (std::abs(q[kBlock + i] - M_PI) < 0.1) ++upright;
  });
  return 100.0 * upright / n;
}

double milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int main() {
  std::printf("derivatives: they differ from finite differences by ~%.0e\n", error_of_derivatives());

  Weights<4, 1> weights;
  weights.goal << 0, M_PI, 0, 0;
  weights.state << 0.01, 0.01, 0.001, 0.001;
  weights.end << 1000, 1000, 100, 100;
  weights.input << 0.01;
  Trajectory<4, 1> guess;
  guess.x = {X::Zero()};
  guess.u.assign(kSteps, U(0.01));
  double before = milliseconds();
  IterativeLqr<4, 1, decltype(step)> search(step, weights, guess);
  const Trajectory<4, 1> plan = search.solve(500, 1e-7);
  double most = 0;
  for (const U& u : plan.u) most = std::max(most, std::abs(force(u[0])));
  std::printf(
      "swing-up:    cost from %.0f to %.1f; ~%zu iterations in ~%.0f ms\n", plan.costs.front(), plan.costs.back(),
      plan.costs.size() - 1, milliseconds() - before);
  std::printf("             the pole ends at %.2f rad; the largest force is %.1f N\n", plan.x.back()[1], most);

  robcogen::batch::ThreadPool pool;  // as many threads as there are cores
  const int n = 20000;
  Trajectory<4, 1> forces_only = plan;
  for (auto& gains : forces_only.feedback) gains.setZero();
  before = milliseconds();
  const double without = percent_upright(forces_only, n, pool), with = percent_upright(plan, n, pool);
  std::printf(
      "many starts: ~%.0f %% end upright without feedback, ~%.0f %% with it; ~%.0f ms for %d million steps\n", without,
      with, milliseconds() - before, 2 * n * kSteps / 1000000);
}
