// The observer of external forces follows a constant force with its time constant, for fixed and floating bases.
#include "robcogen/generic/external_forces.h"

#include "robcogen/generic/simulation.h"
#include "robots.h"

namespace robcogen::test::external_forces_test {
namespace {

template <class Case>
class ExternalForces : public ::testing::Test {};
using Robots = ::testing::Types<Hyl, Torso>;
TYPED_TEST_SUITE(ExternalForces, Robots);

constexpr double kGain = 40;  // 1/s

// The largest error (N m) while the residual follows constant forces on the joints for four time constants.
template <class R>
double largest_error(int steps) {
  const double step = 4 / kGain / steps;
  const R robot;
  std::mt19937_64 engine(11);
  State<R> state = moving_state<R>(engine);
  const typename R::JointState tau = uniform_joints<typename R::JointState>(engine, 5.0);
  const typename R::JointState external = uniform_joints<typename R::JointState>(engine, 3.0);
  ExternalForceObserver<R> observer(robot, state, kGain);
  double largest = 0;
  for (int i = 1; i <= steps; ++i) {
    state = runge_kutta_step(state, step, [&](const State<R>& s) -> decltype(acceleration(robot, s, tau)) {
      return acceleration(robot, s, tau + external);
    });
    typename ExternalForceObserver<R>::Forces error = observer.update(state, tau, step);
    // Backward steps of r' = K (tau_external - r). No wrench acts on the base.
    error.template tail<R::kDof>() -= (1 - std::pow(1 + kGain * step, -i)) * external;
    largest = std::max(largest, error.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(observer.forces().template tail<R::kDof>().norm(), 0.9 * external.norm());
  observer.reset(state);
  EXPECT_EQ(observer.forces().cwiseAbs().maxCoeff(), 0);
  return largest;
}

// The integral is of second order in the step.
TYPED_TEST(ExternalForces, AreFollowed) {
  using R = typename TypeParam::Robot;
  const double coarse = largest_error<R>(200), fine = largest_error<R>(400);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, coarse / 3);
}

}  // namespace
}  // namespace robcogen::test::external_forces_test
