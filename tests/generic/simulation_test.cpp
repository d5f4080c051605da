// Time integration: orders of convergence, and conserved quantities of free motion.
#include "robcogen/generic/simulation.h"

#include "robots.h"

namespace robcogen::test::simulation_test {
namespace {

template <class R>
auto free_motion(const R& robot) {
  return [robot](const State<R>& s) { return acceleration(robot, s, R::JointState::Zero()); };
}

// Springs and dampers, so that no symmetry hides an error. They are scaled by the inertia that each joint moves, so
// that they are stiff for no joint.
template <class R>
auto pushed_motion(const R& robot) {
  const typename R::JointState felt =
      robot.joint_space_inertia(R::JointState::Zero()).diagonal().template tail<R::kDof>();
  return [robot, felt](const State<R>& s) {
    const typename R::JointState wanted = -20 * (s.q.array() + 0.2).sin() - 2 * s.qd.array();
    return acceleration(robot, s, felt.cwiseProduct(wanted));
  };
}

template <class R>
double distance(const State<R>& a, const State<R>& b) {
  double d = (a.q - b.q).norm() + (a.qd - b.qd).norm();
  if constexpr (R::kFloatingBase) {
    d += a.pose.quaternion().angularDistance(b.pose.quaternion()) + (a.pose.position() - b.pose.position()).norm() +
         (a.base_velocity.vector() - b.base_velocity.vector()).norm();
  }
  return d;
}

struct SemiImplicitEuler {
  static constexpr double kOrder = 1;
  template <class State, class Acceleration>
  State operator()(const State& s, double h, const Acceleration& a) const {
    return semi_implicit_euler_step(s, h, a);
  }
};
struct RungeKutta {
  static constexpr double kOrder = 4;
  template <class State, class Acceleration>
  State operator()(const State& s, double h, const Acceleration& a) const {
    return runge_kutta_step(s, h, a);
  }
};

template <class R, class Step>
State<R> simulated(State<R> state, double duration, int steps, const Step& step) {
  const auto a = pushed_motion(R());
  for (int i = 0; i < steps; ++i) state = step(state, duration / steps, a);
  return state;
}

template <class Case>
class Simulation : public ::testing::Test {};
TYPED_TEST_SUITE(Simulation, AllRobots);

// Short enough that the lightest link's motion is smooth, long enough that errors are above rounding.
constexpr double kDuration = 0.05;  // s
// Terms of the next order are still visible at these steps.
constexpr double kOrderTolerance = 0.15;

// Halving the step divides the error by 2^order, measured against a far finer solution.
template <class R, class Step>
double order_of(const State<R>& start, int steps, const Step& step) {
  const State<R> exact = simulated(start, kDuration, 32 * steps, RungeKutta());
  const double coarse = distance(simulated(start, kDuration, steps, step), exact);
  const double fine = distance(simulated(start, kDuration, 2 * steps, step), exact);
  return std::log2(coarse / fine);
}

TYPED_TEST(Simulation, ConvergesInItsOrder) {
  std::mt19937_64 engine(7);
  const auto start = moving_state<typename TypeParam::Robot>(engine);
  EXPECT_NEAR(order_of(start, 400, SemiImplicitEuler()), SemiImplicitEuler::kOrder, kOrderTolerance);
  EXPECT_NEAR(order_of(start, 40, RungeKutta()), RungeKutta::kOrder, kOrderTolerance);
}

template <class R>
double energy(const reflection::Robot& tables, const State<R>& state) {
  const double kinetic = reference::kinetic_energy(tables, motion_of(state));
  if constexpr (R::kFloatingBase) {
    // The potential energy about the base origin does not include the height of that origin.
    const double lifted = -reference::moving_mass(tables) * Gravity::standard().vector().dot(state.pose.position());
    return kinetic + lifted +
           reference::potential_energy(tables, vector(state.q), vector(gravity_in_base(state).vector()));
  } else {
    return kinetic + reference::potential_energy(tables, vector(state.q), vector(Gravity::standard().vector()));
  }
}

// For the energy after one second of free swing, computed by the independent reference. A step of 0.1 ms leaves a
// truncation of about 1e-10 for the lightest links, which turn at some tens of rad/s.
constexpr double kDrift = 1e-8;

TYPED_TEST(Simulation, FreeSwingKeepsItsEnergy) {
  using R = typename TypeParam::Robot;
  std::mt19937_64 engine(8);
  State<R> state = moving_state<R>(engine);
  const auto a = free_motion(R());
  const double before = energy(TypeParam::tables(), state);
  const double kinetic_before = reference::kinetic_energy(TypeParam::tables(), motion_of(state));
  for (int i = 0; i < 10000; ++i) state = runge_kutta_step(state, 1e-4, a);
  const double kinetic = reference::kinetic_energy(TypeParam::tables(), motion_of(state));
  EXPECT_GT(std::abs(kinetic - kinetic_before), 0.1);  // energy was exchanged
  EXPECT_LT(std::abs(energy(TypeParam::tables(), state) - before), kDrift * std::max(kinetic, kinetic_before));
}

template <class Case>
class FloatingSimulation : public ::testing::Test {};
TYPED_TEST_SUITE(FloatingSimulation, FloatingRobots);

// In world axes: position of the centre of mass, momentum, and angular momentum about the centre of mass.
struct Whole {
  Eigen::Vector3d com, linear, spin;
};

template <class R>
Whole whole(const reflection::Robot& tables, const State<R>& state) {
  const double mass = reference::moving_mass(tables);
  const Eigen::Vector3d com = eigen3(reference::first_moment(tables, vector(state.q))) / mass;
  const reference::Vector<double> h = reference::momentum(tables, motion_of(state));
  const Eigen::Vector3d angular(h(0), h(1), h(2)), linear(h(3), h(4), h(5));
  const auto& pose = state.pose;
  return {
      pose.position() + pose.to_world_axes(com), pose.to_world_axes(linear),
      pose.to_world_axes(angular - com.cross(linear))};
}

// Joint forces are internal: whatever they are, the whole robot falls like a stone and keeps its angular momentum.
TYPED_TEST(FloatingSimulation, FallsAsAStone) {
  using R = typename TypeParam::Robot;
  constexpr double kFall = 0.5;  // s
  constexpr int kSteps = 5000;
  std::mt19937_64 engine(9);
  State<R> state = moving_state<R>(engine);
  const Whole before = whole(TypeParam::tables(), state);
  const auto a = pushed_motion(R());
  for (int i = 0; i < kSteps; ++i) state = runge_kutta_step(state, kFall / kSteps, a);
  const Whole after = whole(TypeParam::tables(), state);

  const Eigen::Vector3d g = Gravity::standard().vector();
  const double mass = reference::moving_mass(TypeParam::tables());
  EXPECT_LT((after.linear - before.linear - kFall * mass * g).norm(), kDrift * mass);
  EXPECT_LT((after.com - before.com - kFall * before.linear / mass - kFall * kFall / 2 * g).norm(), kDrift);
  EXPECT_GT(before.spin.norm(), 1);
  EXPECT_LT((after.spin - before.spin).norm(), kDrift * mass);
}

// A body that turns steadily about its own z axis: its angle is the rate times the time, whatever the step is.
TEST(SemiImplicitEuler, TurnsByTheAngularVelocity) {
  using R = quadruped::Robot;
  State<R> state;
  state.base_velocity = Twist(Eigen::Vector3d(0, 0, 2.0), Eigen::Vector3d::Zero());
  const auto steady = [](const State<R>&) {
    return R::GeneralizedAcceleration{R::JointState::Zero(), SpatialAcceleration()};
  };
  for (int i = 0; i < 10; ++i) state = semi_implicit_euler_step(state, 0.1, steady);
  const Eigen::Quaterniond expected(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ()));
  EXPECT_LT(state.pose.quaternion().angularDistance(expected), 1e-7);  // acos near 1 loses half of the digits
  EXPECT_NEAR(state.pose.quaternion().norm(), 1, 1e-15);
}

}  // namespace
}  // namespace robcogen::test::simulation_test
