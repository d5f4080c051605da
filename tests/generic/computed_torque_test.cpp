// Joint errors under computed torque decay as their poles prescribe, for every robot.
#include "robcogen/generic/computed_torque.h"

#include "robcogen/generic/simulation.h"
#include "robots.h"

namespace robcogen::test::computed_torque_test {
namespace {

template <class Case>
class ComputedTorque : public ::testing::Test {};
TYPED_TEST_SUITE(ComputedTorque, AllRobots);

// Truncation of 500 steps, and rounding of inverse and forward dynamics.
constexpr double kTolerance = 1e-7;

template <class R>
Setpoint<R> wanted_at(double t) {
  Setpoint<R> wanted;
  for (int j = 0; j < R::kDof; ++j) {
    const double w = 2 + 0.3 * j;
    wanted.q[j] = 0.4 * std::sin(w * t + j);
    wanted.qd[j] = 0.4 * w * std::cos(w * t + j);
    wanted.qdd[j] = -w * w * wanted.q[j];
  }
  return wanted;
}

TYPED_TEST(ComputedTorque, ErrorsDecayAsThePolesSay) {
  using R = typename TypeParam::Robot;
  constexpr double kPole = 8, kStep = 1e-3;  // 1/s, s
  const R robot;
  std::mt19937_64 engine(4);
  State<R> state = moving_state<R>(engine);
  const typename R::JointState e = state.q - wanted_at<R>(0).q, ed = state.qd - wanted_at<R>(0).qd;
  ASSERT_GT(e.norm(), 0.3);

  // Each stage of a step evaluates the setpoint at its own time.
  double largest = 0;
  for (int i = 0; i < 500; ++i) {
    const double t = i * kStep;
    int stage = 0;
    state = runge_kutta_step(state, kStep, [&](const State<R>& s) {
      constexpr double kStages[] = {0, 0.5, 0.5, 1};
      const Setpoint<R> wanted = wanted_at<R>(t + kStages[stage++] * kStep);
      return acceleration(robot, s, computed_torque(robot, s, wanted, critically_damped<R>(kPole)));
    });
    const double now = t + kStep;
    const typename R::JointState expected = (e + (ed + kPole * e) * now) * std::exp(-kPole * now);
    largest = std::max(largest, (state.q - wanted_at<R>(now).q - expected).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(largest, kTolerance);
}

}  // namespace
}  // namespace robcogen::test::computed_torque_test
